#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what the water does to a mesh, open or closed, by pressure over triangles that are quartered where
/// the surface cuts them, to 1e-7 of the mesh's size.
void addReferenceSurface(const TriangleMesh& mesh, const WaterPlane& plane, WetIntegrals& integrals);

/// Adds what the water does to a solid, by pressure over its curved surface and flat ends: Gauss quadrature
/// round the wet arc of each section and along the axis, between the sections that touch the surface.
void addReferenceSurface(const SolidOfRevolution& solid, const WaterPlane& plane, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
