#pragma once

#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Adds what waves do to the mesh of a hull: as `addMeshInWaves`, but from the highest clusters of its packed
/// mesh down (of which there must be some). Children that are wholly wet are summed up by their moments, with
/// the water to second order; packs at the surface under the plane that is tangent to the head, where that
/// is near enough, and else triangle by triangle.
void addClustersInWaves(const Hull& hull, const WaterPatch& water, double headError,
                        const HydrostaticQuery& query, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
