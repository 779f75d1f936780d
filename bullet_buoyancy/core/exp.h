#pragma once

#include "bullet_buoyancy/core/lanes.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

/// Exponentials. Relative error below 5e-16; numbers below -708 count as that, and those above 709.
///
/// Reduced by multiples of ln 2 in two parts, of which the first has few enough bits that its multiples are
/// exact; then Taylor's polynomial, whose remainder is below 2e-16.
inline Lanes<double> expOf(const Lanes<double>& numbers) {
    using Numbers = Lanes<double>;
    // Adding this leaves no bits for fractions: rounds to the nearest integer, which its last bits then are.
    // Needs strict arithmetic.
    constexpr double rounder = 0x1.8p52;
    const Numbers lowest = spread(-708.0), highest = spread(709.0);
    const Numbers above = numbers > lowest ? numbers : lowest, x = above < highest ? above : highest;
    const Numbers rounded = x * 1.4426950408889634 + rounder;
    const Numbers doublings = rounded - rounder;
    const Numbers r = (x - doublings * 0x1.62e42fefap-1) - doublings * 0x1.cf79abc9e3b3ap-40;
    const Numbers r2 = r * r, r4 = r2 * r2;
    // In Estrin's order, whose sums do not wait for each other.
    const Numbers rest =
        ((0.5 + 0.16666666666666666 * r) + (0.041666666666666664 + 0.008333333333333333 * r) * r2) +
        (((0.001388888888888889 + 0.0001984126984126984 * r) +
          (2.48015873015873e-05 + 2.7557319223985893e-06 * r) * r2) +
         ((2.755731922398589e-07 + 2.505210838544172e-08 * r) + 2.08767569878681e-09 * r2) * r4) *
            r4;
    constexpr int mantissaBits = 52;
    NumbersOrBits result{1.0 + r * (1.0 + r * rest)}, integers{rounded};
    result.bits += integers.bits << mantissaBits;
    return result.numbers;
}

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
