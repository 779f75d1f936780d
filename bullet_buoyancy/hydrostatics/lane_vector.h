#pragma once

#include "bullet_buoyancy/core/lanes.h"
#include "bullet_buoyancy/hull/packs.h"

// Only kernels include this: see core/lanes.h.
namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

template <typename Real>
struct LaneVector {
    Lanes<Real> x, y, z;

    Lanes<Real> dot(const LaneVector& o) const { return x * o.x + y * o.y + z * o.z; }
    LaneVector operator+(const LaneVector& o) const { return {x + o.x, y + o.y, z + o.z}; }
    LaneVector operator-(const LaneVector& o) const { return {x - o.x, y - o.y, z - o.z}; }
};

template <typename Real>
LaneVector<Real> operator*(const Lanes<Real>& factor, const LaneVector<Real>& v) {
    return {factor * v.x, factor * v.y, factor * v.z};
}

template <typename Real>
LaneVector<Real> select(const Truths<Real>& truths, const LaneVector<Real>& yes, const LaneVector<Real>& no) {
    return {truths ? yes.x : no.x, truths ? yes.y : no.y, truths ? yes.z : no.z};
}

template <typename Real>
LaneVector<Real> loadVector(const PackRow<Real> (&rows)[3], int lane) {
    return {load(rows[0].lane + lane), load(rows[1].lane + lane), load(rows[2].lane + lane)};
}

template <typename Real>
void addTo(PackRow<Real>& row, int lane, const Lanes<Real>& summand) {
    store<Real>(load(row.lane + lane) + summand, row.lane + lane);
}

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
