#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>

namespace bullet_buoyancy {

/// Exponentials of a few numbers at once, in vector instructions where there are any. Relative error below
/// 5e-16; numbers below -708 count as that, and those above 709.
///
/// Reduced by multiples of ln 2 in two parts, of which the first has few enough bits that its multiples are
/// exact; then Taylor's polynomial, whose remainder is below 2e-16.
template <int count>
Eigen::Array<double, count, 1> expOf(const Eigen::Array<double, count, 1>& numbers) {
    using Array = Eigen::Array<double, count, 1>;
    // Adding this leaves no bits for fractions: rounds to the nearest integer, which its last bits then are.
    // Needs strict arithmetic.
    constexpr double rounder = 0x1.8p52;
    const Array x = numbers.max(-708.0).min(709.0);
    const Array rounded = x * 1.4426950408889634 + rounder;
    const Array doublings = rounded - rounder;
    const Array r = (x - doublings * 0x1.62e42fefap-1) - doublings * 0x1.cf79abc9e3b3ap-40;
    Array result =
        (((((((((2.08767569878681e-09 * r + 2.505210838544172e-08) * r + 2.755731922398589e-07) * r +
               2.7557319223985893e-06) *
                  r +
              2.48015873015873e-05) *
                 r +
             0.0001984126984126984) *
                r +
            0.001388888888888889) *
               r +
           0.008333333333333333) *
              r +
          0.041666666666666664) *
             r +
         0.16666666666666666) *
            r +
        0.5;
    result = 1 + r * (1 + r * result);
    constexpr int mantissaBits = 52;
    for (int i = 0; i < count; ++i) {
        std::uint64_t integer, bits;
        std::memcpy(&integer, &rounded[i], sizeof integer);
        std::memcpy(&bits, &result[i], sizeof bits);
        bits += integer << mantissaBits;
        std::memcpy(&result[i], &bits, sizeof bits);
    }
    return result;
}

}  // namespace bullet_buoyancy
