#pragma once

#include "bullet_buoyancy/hydrostatics/mesh_sum.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what water does to a hull whose surface about it is a plane, square to which pressure grows with
/// depth: constant time for a hull that is wholly dry, or wholly wet without open edges. An open mesh is
/// always summed up one by one.
void addHullUnderPlane(const Hull& hull, const WaterPlane& plane, MeshSum sum, const HydrostaticQuery& query,
                       WetIntegrals& integrals);

}  // namespace bullet_buoyancy
