#pragma once

#include <cmath>

#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy::scenes {

/// Of the i-th of many bodies on a grid, `distance` (m) apart, which float near z = 0: each at another
/// height, up to `spread` (m) from there, and heel, so that nothing can be learnt by heart.
inline Pose crowdPose(int i, double distance, double spread) {
    constexpr int bodiesInARow = 32;
    Pose pose;
    pose.position = {distance * (i % bodiesInARow), distance * (i / bodiesInARow), spread * std::sin(i)};
    pose.orientation = Eigen::AngleAxisd(0.2 * std::sin(3 * i), Vec3(std::cos(i), std::sin(i), 0));
    return pose;
}

}  // namespace bullet_buoyancy::scenes
