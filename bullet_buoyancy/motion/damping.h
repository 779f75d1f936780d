#pragma once

#include <cmath>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// The exact solution of dv/dt = a - rate v over one step with constant a: v(dt) = decay v(0) + gain a. Never
/// reverses a motion, whatever rate and dt, and does not depend on how a time is cut into steps.
struct DampedStep {
    double dt;     ///< s
    double decay;  ///< 1
    double gain;   ///< s

    /// `rate` >= 0 in 1/s, `step` > 0 in s.
    DampedStep(double rate, double step)
        : dt(step),
          decay(std::exp(-rate * step)),
          gain(rate * step > 0 ? -std::expm1(-rate * step) / rate : step) {}

    /// A velocity or momentum after the step under a constant `load` (its rate of change), where contacts and
    /// joints add theirs only after us: their load in the step before, `others`, counts as far as it relieves
    /// ours. So a free body approaches its terminal velocity exactly, and one that is held gets the whole of
    /// its load to press with.
    Vec3 advance(const Vec3& value, const Vec3& load, const Vec3& others) const {
        const bool relieved = (load + others).squaredNorm() < load.squaredNorm();
        const Vec3 net = relieved ? Vec3(load + others) : load;
        return decay * value + dt * load + (gain - dt) * net;
    }
};

/// The rate (1/s) of a damping published as a factor `alpha` (above 0, at most 1) a tick of `referenceTick`
/// seconds. 0.98 a tick of 0.02 s, "about right for water", is 1.01/s; 0.95, "heavy oil", 2.56/s.
inline double dampingRate(double alpha, double referenceTick) {
    return -std::log(alpha) / referenceTick;
}

}  // namespace bullet_buoyancy
