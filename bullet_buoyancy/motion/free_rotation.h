#pragma once

#include <Eigen/Geometry>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// The rotation of a body on which no torque acts, over `dt` seconds (either sign): its orientation after is
/// its orientation before times the result. Unit length; orientations are body to world, and all here is in
/// the body's principal axes at the start.
///
/// `principal`: moments of inertia, kg m^2, above 0. `momentumInBody`: angular momentum, kg m^2/s.
///
/// Exact but for rounding, 2e-14 rad at most for a turn by pi/4. A faster body is turned in pieces of that
/// size; after 1000 of them it stops short. Energy and momentum are kept to rounding at any spin. Moments
/// that break the triangle inequality are served too.
Eigen::Quaterniond turnFreely(const Vec3& principal, const Vec3& momentumInBody, double dt);

/// The same for a body that merely rocks, at a quarter of the cost: the relative error of the turn is about a
/// hundredth of the fourth power of its angle (5e-11 rad at 0.02 rad). Momentum is kept to rounding all the
/// same.
Eigen::Quaterniond turnGently(const Vec3& principal, const Vec3& momentumInBody, double dt);

/// Rotation vector (axis times angle, rad) of a rotation given by a unit quaternion. The angle is in [0, pi],
/// the relative error some 1e-16 near 0 as elsewhere.
Vec3 rotationVector(const Eigen::Quaterniond& rotation);

}  // namespace bullet_buoyancy
