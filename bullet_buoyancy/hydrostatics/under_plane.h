#pragma once

#include "bullet_buoyancy/hydrostatics/mesh_sum.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what water under a plane, level or tilted, does to a hull: its head is the distance from the plane. A
/// hull that is wholly dry costs constant time, and so does one wholly under water, but for open edges. An
/// open mesh is always summed up one by one.
void addHullUnderPlane(const Hull& hull, const WaterPlane& plane, MeshSum sum, const HydrostaticQuery& query,
                       WetIntegrals& integrals);

/// Whether `displacementUnderPlane` has all that is asked for.
bool isDisplacementAlone(const Hull& hull, const HydrostaticQuery& query);

/// What a closed hull without solids of revolution displaces.
Displacement displacementUnderPlane(const Hull& hull, const WaterPlane& plane, MeshSum sum,
                                    Precision precision);

}  // namespace bullet_buoyancy
