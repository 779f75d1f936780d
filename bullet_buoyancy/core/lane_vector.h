#pragma once

#include "bullet_buoyancy/core/lanes.h"

// Only kernels include this: see core/lanes.h.
namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

template <typename Real>
struct LaneVector {
    Lanes<Real> x, y, z;

    Lanes<Real> dot(const LaneVector& o) const { return x * o.x + y * o.y + z * o.z; }
    LaneVector cross(const LaneVector& o) const {
        return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
    }
    LaneVector times(const LaneVector& o) const { return {x * o.x, y * o.y, z * o.z}; }
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

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
