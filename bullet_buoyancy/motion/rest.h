#pragma once

#include <cmath>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// How fast a body is and how far its load is from balance.
struct Unrest {
    double speed;                ///< of translation and rotation together: sqrt(2 kinetic energy / mass), m/s
    double acceleration;         ///< by the loads on it that do not balance, m/s^2
    double angularAcceleration;  ///< torque that does not balance over mass and length, m/s^2
};

/// What of a load is left to move a body, given the share that contacts and joints take (see Relief). One
/// that they hold comes to rest with them: their small change from step to step is no imbalance.
inline double unbalanced(double load, double relief) {
    return relief > 0.5 ? 0 : load;
}

/// Whether a body of a given length (m) may be taken for still where gravity (m/s^2) is so strong: its Froude
/// number, speed / sqrt(g length), is below 0.005, so that it swings by less than a hundredth of its length,
/// and its loads balance to 1e-4 of its weight, so that it does not merely creep.
inline bool isAtRest(const Unrest& unrest, double gravity, double length) {
    constexpr double froudeNumber = 0.005, imbalance = 1e-4;
    return unrest.speed <= froudeNumber * std::sqrt(gravity * length) &&
           unrest.acceleration <= imbalance * gravity && unrest.angularAcceleration <= imbalance * gravity;
}

}  // namespace bullet_buoyancy
