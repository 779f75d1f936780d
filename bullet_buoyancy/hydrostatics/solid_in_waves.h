#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Adds what waves do to a solid: in closed form with the water to second order about its middle, where that
/// is enough for errors of the head of about `headError` (m), else by panels. The bound of what remains goes
/// to `integrals.error` and `integrals.lastingError`.
void addSolidInWaves(const SolidOfRevolution& solid, const WaterPatch& water, double headError,
                     const HydrostaticQuery& query, WetIntegrals& integrals);

/// The same for a sphere.
void addSphereInWaves(const Sphere& sphere, const WaterPatch& water, double headError,
                      const HydrostaticQuery& query, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
