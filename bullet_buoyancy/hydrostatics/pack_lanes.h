#pragma once

#include "bullet_buoyancy/core/lane_vector.h"
#include "bullet_buoyancy/hull/packs.h"

// Only kernels include this: see core/lanes.h.
namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

template <typename Real>
LaneVector<Real> loadVector(const PackRow<Real> (&rows)[3], int lane) {
    return {load(rows[0].lane + lane), load(rows[1].lane + lane), load(rows[2].lane + lane)};
}

template <typename Real>
void addTo(PackRow<Real>& row, int lane, const Lanes<Real>& summand) {
    store<Real>(load(row.lane + lane) + summand, row.lane + lane);
}

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
