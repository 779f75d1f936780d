#pragma once

#include <LinearMath/btScalar.h>

#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy::test {

/// The usual substep, s.
inline constexpr double dt = 1.0 / 60;

/// A pose of Bullet's is rounded to this share of its size, and so is whatever follows from it.
inline constexpr double poseRounding = sizeof(btScalar) == 4 ? 1e-6 : 1e-14;

inline Pose at(const Vec3& position) {
    return {position, Eigen::Quaterniond::Identity()};
}

}  // namespace bullet_buoyancy::test
