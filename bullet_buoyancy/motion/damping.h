#pragma once

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// The exact solution of dv/dt = a - rate v over one step with constant a: v(dt) = decay v(0) + gain a. Does
/// not depend on how a time is cut into steps, and drag alone never reverses a motion, whatever rate and dt.
struct DampedStep {
    double dt;     ///< s
    double decay;  ///< 1
    double gain;   ///< s

    /// `rate` >= 0 in 1/s (infinite: stops at once), `step` > 0 in s.
    DampedStep(double rate, double step)
        : dt(step),
          decay(std::exp(-rate * step)),
          gain(rate * step > 0 ? -std::expm1(-rate * step) / rate : step) {}

    /// A velocity or momentum after the step under a constant `load` (its rate of change), of which contacts
    /// and joints take the share `relief` (0 to 1) upon them, but only after us. So a free body approaches
    /// its terminal velocity exactly, and one that is held gets the whole of its load to press with.
    Vec3 advance(const Vec3& value, const Vec3& load, double relief) const {
        return decay * value + (gain + relief * (dt - gain)) * load;
    }
};

/// The share of a load that others take upon them, told from what they did in the last two steps: a blow
/// lasts but one.
class Relief {
public:
    void restart() { m_last = m_beforeLast = 0; }

    /// `others`: what they added in the step that has passed, as a rate of change like `load`.
    double update(const Vec3& load, const Vec3& others) {
        const double square = load.squaredNorm();
        m_beforeLast = m_last;
        m_last = square > 0 ? std::clamp(-others.dot(load) / square, 0.0, 1.0) : 0;
        return std::min(m_last, m_beforeLast);
    }

private:
    double m_last = 0, m_beforeLast = 0;
};

/// The rate (1/s) of a damping published as a factor `alpha` (above 0, at most 1) a tick of `referenceTick`
/// seconds. 0.98 a tick of 0.02 s, "about right for water", is 1.01/s; 0.95, "heavy oil", 2.56/s.
inline double dampingRate(double alpha, double referenceTick) {
    return -std::log(alpha) / referenceTick;
}

}  // namespace bullet_buoyancy
