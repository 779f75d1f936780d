#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what water under a plane, level or tilted, does to a hull: its head is the distance from the plane. A
/// hull that is wholly dry costs constant time, and so does one wholly under water, but for open edges.
void addHullUnderPlane(const Hull& hull, const WaterPlane& plane, const HydrostaticQuery& query,
                       WetIntegrals& integrals);

}  // namespace bullet_buoyancy
