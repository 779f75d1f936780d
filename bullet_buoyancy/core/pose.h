#pragma once

#include <Eigen/Geometry>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// Where a body's centre of mass is and how its axes are turned: world = position + orientation * body.
struct Pose {
    Vec3 position = Vec3::Zero();                                     ///< centre of mass in the world, m
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, unit length

    /// Its columns are the body's axes in the world.
    Mat3 worldFromBody() const { return orientation.toRotationMatrix(); }
};

}  // namespace bullet_buoyancy
