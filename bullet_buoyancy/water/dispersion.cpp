#include "bullet_buoyancy/water/dispersion.h"

#include <cassert>
#include <cmath>

namespace bullet_buoyancy {

double frequencyOfWavenumber(double wavenumber, const WaterDepth& water) {
    assert(wavenumber >= 0 && water.depth > 0 && water.gravity > 0);
    if (wavenumber == 0) return 0;
    return std::sqrt(water.gravity * wavenumber * std::tanh(wavenumber * water.depth));
}

double wavenumberOfFrequency(double frequency, const WaterDepth& water) {
    assert(frequency >= 0 && water.depth > 0 && water.gravity > 0);
    const double deep = frequency * frequency / water.gravity;
    const double target = deep * water.depth;  // of q tanh(q) with q = k depth
    // tanh is 1 to double precision from 19 on.
    if (deep == 0 || target > 20) return deep;
    // Within 0.8 % of the root (Guo 2002, Coastal Engineering 45): four steps of Newton's method square that
    // to rounding.
    constexpr double exponent = 2.4908;
    double q = target * std::pow(-std::expm1(-std::pow(target, exponent / 2)), -1 / exponent);
    for (int step = 0; step < 4; ++step) {
        const double t = std::tanh(q);
        q -= (q * t - target) / (t + q * (1 - t * t));
    }
    return q / water.depth;
}

}  // namespace bullet_buoyancy
