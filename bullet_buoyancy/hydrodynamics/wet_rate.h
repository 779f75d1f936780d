#pragma once

namespace bullet_buoyancy {

/// The rate (1/s) at which water slows a body, given the rate for a body wholly under water. In proportion to
/// the share of its volume that is wet, or, as published, in full as soon as it is wet at all; nothing in the
/// air.
inline double wetRate(double rate, double wetFraction, bool scaleByWetFraction) {
    if (wetFraction <= 0) return 0;
    return scaleByWetFraction ? rate * (wetFraction < 1 ? wetFraction : 1) : rate;
}

}  // namespace bullet_buoyancy
