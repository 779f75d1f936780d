#pragma once

#include <cmath>

namespace bullet_buoyancy {

/// The exact solution of dv/dt = a - rate v over one step with constant a: v(dt) = decay v(0) + gain a. Never
/// reverses a motion, whatever rate and dt, and does not depend on how a time is cut into steps.
struct DampedStep {
    double decay;  ///< 1
    double gain;   ///< s

    /// `rate` >= 0 in 1/s, `dt` > 0 in s.
    DampedStep(double rate, double dt)
        : decay(std::exp(-rate * dt)), gain(rate * dt > 0 ? -std::expm1(-rate * dt) / rate : dt) {}
};

/// The rate (1/s) of a damping published as a factor `alpha` (above 0, at most 1) a tick of `referenceTick`
/// seconds. 0.98 a tick of 0.02 s, "about right for water", is 1.01/s; 0.95, "heavy oil", 2.56/s.
inline double dampingRate(double alpha, double referenceTick) {
    return -std::log(alpha) / referenceTick;
}

}  // namespace bullet_buoyancy
