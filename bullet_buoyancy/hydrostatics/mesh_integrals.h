#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what the water does to the triangles of a mesh: each clipped, the linear pressure on it integrated
/// exactly.
void addMesh(const TriangleMesh& mesh, const WaterPlane& plane, const HydrostaticQuery& query,
             WetIntegrals& integrals);

}  // namespace bullet_buoyancy
