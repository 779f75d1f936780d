#pragma once

#include <Eigen/Core>

namespace bullet_buoyancy {

/// Sines and cosines of a few angles (rad) at once, in vector instructions where there are any: three times
/// as fast as the standard library's. Absolute error below 5e-16 for angles up to 5e7.
///
/// Reduced by multiples of pi in three parts (Cody and Waite 1980), of which the first two have 29 bits each
/// so that their multiples are exact; then polynomials that interpolate at Chebyshev nodes over half a
/// period.
template <int count>
void sinCos(const Eigen::Array<double, count, 1>& angle, Eigen::Array<double, count, 1>& sine,
            Eigen::Array<double, count, 1>& cosine) {
    using Array = Eigen::Array<double, count, 1>;
    // Adding this leaves no bits for fractions: rounds to the nearest integer. Needs strict arithmetic.
    constexpr double rounder = 0x1.8p52;
    const Array turns = (angle * 0.31830988618379067 + rounder) - rounder;
    const Array r =
        ((angle - turns * 0x1.921fb54p+1) - turns * 0x1.10b4611p-29) - turns * 0x1.4c4c6628b80dcp-58;
    const Array oddness = turns - 2 * ((turns * 0.5 + rounder) - rounder);
    const Array sign = 1 - 2 * oddness * oddness;
    const Array t = r * r;
    sine = (((((((2.7314447669074988e-15 * t - 7.643970296792245e-13) * t + 1.605897731246389e-10) * t -
                2.505210761699618e-08) *
                   t +
               2.7557319219163234e-06) *
                  t -
              1.9841269841254974e-04) *
                 t +
             8.333333333333316e-03) *
                t -
            0.16666666666666666);
    sine = sign * (r + r * t * sine);
    cosine = (((((((-1.5218638368848068e-16 * t + 4.7778779252426735e-14) * t - 1.1470712272749366e-11) * t +
                  2.0876756602875463e-09) *
                     t -
                 2.7557319221569563e-07) *
                    t +
                2.480158730157985e-05) *
                   t -
               1.388888888888888e-03) *
                  t +
              4.1666666666666664e-02);
    cosine = sign * (1 + t * (t * cosine - 0.5));
}

}  // namespace bullet_buoyancy
