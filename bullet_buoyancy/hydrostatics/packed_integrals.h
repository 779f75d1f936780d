#pragma once

#include "bullet_buoyancy/hull/packed_mesh.h"
#include "bullet_buoyancy/hydrostatics/mesh_sum.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// By kernels in that precision. `sum`: inPacks or inClusters.
Displacement displacementOf(const PackedMesh& mesh, const WaterPlane& plane, MeshSum sum,
                            Precision precision);

/// Adds what water under a plane does to a closed mesh: as `addMesh`, by kernels in the query's precision.
/// `sum`: inPacks or inClusters.
void addPackedMesh(const PackedMesh& mesh, const WaterPlane& plane, MeshSum sum,
                   const HydrostaticQuery& query, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
