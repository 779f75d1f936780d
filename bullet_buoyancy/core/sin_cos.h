#pragma once

#include "bullet_buoyancy/core/lanes.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

struct SinCos {
    Lanes<double> sine, cosine;
};

/// Sines and cosines of angles (rad). Absolute error below 5e-16 for angles up to 5e7.
///
/// Reduced by multiples of pi in three parts (Cody and Waite 1980), of which the first two have 29 bits each
/// so that their multiples are exact; then polynomials that interpolate at Chebyshev nodes over half a
/// period.
inline SinCos sinCos(const Lanes<double>& angle) {
    using Numbers = Lanes<double>;
    // Adding this leaves no bits for fractions: rounds to the nearest integer. Needs strict arithmetic.
    constexpr double rounder = 0x1.8p52;
    const Numbers turns = (angle * 0.31830988618379067 + rounder) - rounder;
    const Numbers r =
        ((angle - turns * 0x1.921fb54p+1) - turns * 0x1.10b4611p-29) - turns * 0x1.4c4c6628b80dcp-58;
    const Numbers oddness = turns - 2.0 * ((turns * 0.5 + rounder) - rounder);
    const Numbers sign = 1.0 - 2.0 * oddness * oddness;
    const Numbers t = r * r, t2 = t * t, t4 = t2 * t2;
    // In Estrin's order, whose sums do not wait for each other.
    const Numbers sine = ((-0.16666666666666666 + 8.333333333333316e-03 * t) +
                          (-1.9841269841254974e-04 + 2.7557319219163234e-06 * t) * t2) +
                         ((-2.505210761699618e-08 + 1.605897731246389e-10 * t) +
                          (-7.643970296792245e-13 + 2.7314447669074988e-15 * t) * t2) *
                             t4;
    const Numbers cosine = ((4.1666666666666664e-02 - 1.388888888888888e-03 * t) +
                            (2.480158730157985e-05 - 2.7557319221569563e-07 * t) * t2) +
                           ((2.0876756602875463e-09 - 1.1470712272749366e-11 * t) +
                            (4.7778779252426735e-14 - 1.5218638368848068e-16 * t) * t2) *
                               t4;
    return {sign * (r + r * t * sine), sign * (1.0 + t * (t * cosine - 0.5))};
}

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
