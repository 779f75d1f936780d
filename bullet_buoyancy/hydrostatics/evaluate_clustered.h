#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// As `evaluateBatch`, but only those triangles are looked at that are near the surface: of clusters that are
/// wholly wet the moments do, made once with the hull, in waves with the water to second order. The cost
/// grows as the waterline does, about as the square root of the number of triangles.
HydrostaticResult evaluateClustered(const Hull& hull, const Pose& pose, const WaterField& water,
                                    const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
