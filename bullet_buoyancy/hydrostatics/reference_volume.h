#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what the water does to a closed mesh, by Archimedes: its volume as signed tetrahedra, each clipped at
/// the surface. The waterplane comes from its outline by Green's theorem.
void addReferenceVolume(const TriangleMesh& mesh, const WaterPlane& plane, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
