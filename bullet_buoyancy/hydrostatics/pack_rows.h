#pragma once

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/hull/packs.h"

namespace bullet_buoyancy {

inline Vec3 vectorOf(const PackRow<double> (&rows)[3], int lane) {
    return {rows[0].lane[lane], rows[1].lane[lane], rows[2].lane[lane]};
}

/// Always in the same order.
template <typename Real>
double sumOf(const PackRow<Real>& row) {
    Real eight[8], four[4];
    for (int i = 0; i < 8; ++i)
        eight[i] = row.lane[i] + row.lane[i + 8];
    for (int i = 0; i < 4; ++i)
        four[i] = eight[i] + eight[i + 4];
    return (double(four[0]) + double(four[2])) + (double(four[1]) + double(four[3]));
}

template <typename Real>
Vec3 sumOf(const PackRow<Real> (&rows)[3]) {
    return {sumOf(rows[0]), sumOf(rows[1]), sumOf(rows[2])};
}

/// Of rows in the order xx, xy, xz, yy, yz, zz.
template <typename Real>
Mat3 symmetricSumOf(const PackRow<Real> (&rows)[6]) {
    const double xx = sumOf(rows[0]), xy = sumOf(rows[1]), xz = sumOf(rows[2]), yy = sumOf(rows[3]),
                 yz = sumOf(rows[4]), zz = sumOf(rows[5]);
    Mat3 sum;
    sum << xx, xy, xz,  //
        xy, yy, yz,     //
        xz, yz, zz;
    return sum;
}

}  // namespace bullet_buoyancy
