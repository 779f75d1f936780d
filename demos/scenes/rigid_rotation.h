#pragma once

#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy::scenes {

/// A rigid body that turns freely about its centre of mass.
struct FreeRotation {
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world
    Vec3 spin = Vec3::Zero();                                         ///< body axes, rad/s
};

/// Euler's equations and the quaternion's, by Runge and Kutta's fourth order in `steps` steps: the reference
/// for steppers. `inertia`: principal moments along the body's axes, kg m^2.
FreeRotation rotateFreely(FreeRotation rotation, const Vec3& inertia, double seconds, int steps);

}  // namespace bullet_buoyancy::scenes
