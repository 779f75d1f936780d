#pragma once

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/motion/calm_limits.h"

namespace bullet_buoyancy {

/// The exact solution of dv/dt = a - rate v over one step with constant a: v(dt) = decay v(0) + gain a. Does
/// not depend on how a time is cut into steps, and drag alone never reverses a motion, whatever rate and dt.
struct DampedStep {
    double rate;          ///< 1/s
    double dt;            ///< s
    double decay;         ///< 1
    double gain;          ///< s
    double gainOfTravel;  ///< integral of the gain over the step, s^2

    /// `decayRate` >= 0 in 1/s (infinite: stops at once), `step` > 0 in s.
    DampedStep(double decayRate, double step)
        : rate(decayRate), dt(step), decay(1), gain(step), gainOfTravel(step * step / 2) {
        const double x = rate * step;
        if (!(x > 0)) return;
        if (x < dampingSeriesEnds) {
            const double second = secondOrder(x), lost = x * (1 - x * second);
            decay = 1 - lost;
            gain = step * (1 - x * second);
            gainOfTravel = step * step * second;
        } else {
            const double lost = -std::expm1(-x);
            decay = 1 - lost;
            gain = lost / rate;
            gainOfTravel = (step - gain) / rate;
        }
    }

    /// A velocity or momentum after the step under a constant `load` (its rate of change), which acts for
    /// `extra` (s) more without decay.
    Vec3 advance(const Vec3& value, const Vec3& load, double extra = 0) const {
        return decay * value + (gain + extra) * load;
    }

    /// The time (s) by which a load seems to act shorter over two such steps, because what it gives decays.
    /// A body that is held by others does not move by its load, and must get this in full to press with.
    double lostInTwoSteps() const { return 2 * dt - gain * (1 + decay); }

    /// The integral of the value over the step, from `value` under a constant `load`.
    Vec3 travel(const Vec3& value, const Vec3& load) const { return gain * value + gainOfTravel * load; }

private:
    /// (exp(-x) - 1 + x) / x^2, by its Taylor series.
    static double secondOrder(double x) {
        const double y = x * x;
        const double even = 1. / 2 + y * (1. / 24 + y * (1. / 720 + y * (1. / 40320 + y * (1. / 3628800))));
        const double odd =
            1. / 6 + y * (1. / 120 + y * (1. / 5040 + y * (1. / 362880 + y * (1. / 39916800))));
        return even - x * odd;
    }
};

/// The share of a load that others take upon them, told from what it gave the body in the last two steps and
/// what they took of that: a blow lasts but one.
class Relief {
public:
    void restart() { m_last = m_beforeLast = 0; }

    double share() const { return std::min(m_last, m_beforeLast); }

    /// They took nothing of late.
    bool isNone() const { return m_last == 0 && m_beforeLast == 0; }

    /// What the load added in the step that has passed, and what they did, as changes of a velocity or
    /// momentum.
    void update(const Vec3& load, const Vec3& others) {
        const double square = load.squaredNorm();
        m_beforeLast = m_last;
        m_last = square > 0 ? std::clamp(-others.dot(load) / square, 0.0, 1.0) : 0;
    }

    /// The same of a step in which they did nothing.
    void updateUntouched() {
        m_beforeLast = m_last;
        m_last = 0;
    }

private:
    friend struct StateMembers;

    double m_last = 0, m_beforeLast = 0;
};

/// The rate (1/s) of a damping published as a factor `alpha` (above 0, at most 1) a tick of `referenceTick`
/// seconds. 0.98 a tick of 0.02 s, "about right for water", is 1.01/s; 0.95, "heavy oil", 2.56/s.
inline double dampingRate(double alpha, double referenceTick) {
    return -std::log(alpha) / referenceTick;
}

}  // namespace bullet_buoyancy
