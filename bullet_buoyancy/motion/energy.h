#pragma once

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// kg, m/s: J
inline double translationalEnergy(double mass, const Vec3& velocity) {
    return mass * velocity.squaredNorm() / 2;
}

/// kg m^2/s, rad/s: J
inline double rotationalEnergy(const Vec3& angularMomentum, const Vec3& spin) {
    return angularMomentum.dot(spin) / 2;
}

/// kg, m/s^2, m above a level of zero energy: J
inline double gravitationalEnergy(double mass, const Vec3& gravity, const Vec3& position) {
    return -mass * gravity.dot(position);
}

}  // namespace bullet_buoyancy
