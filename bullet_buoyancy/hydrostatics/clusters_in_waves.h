#pragma once

#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Adds what waves do to the mesh of a hull: as `addMeshInWaves`, but from the highest clusters of its packed
/// mesh down (there must be some). Children that are wholly wet are summed up by their moments, with the
/// water to second order; of the others, wholly wet triangles sixteen at a time, and those at the surface one
/// by one. The force is in error by no more than that of the expansions, as one by one, but the bound is
/// looser: returns about how much, as `integrals.error`.
Vec3 addClustersInWaves(const Hull& hull, const WaterPatch& water, double headError,
                        const HydrostaticQuery& query, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
