#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Adds what waves do to a solid: in closed form for the surface's tangent plane at the solid, and what the
/// surface strays from that by quadrature, where it is more than a small part of `headError` (m). The bound
/// of what remains goes to `integrals.error`; most of it is at the waterline, and grows with the square of
/// the solid's size over the waves' length.
void addSolidInWaves(const SolidOfRevolution& solid, const WaterPatch& water, double headError,
                     const HydrostaticQuery& query, WetIntegrals& integrals);

/// The same, all in closed form, with the water to second order about the sphere's centre.
void addSphereInWaves(const Sphere& sphere, const WaterPatch& water, const HydrostaticQuery& query,
                      WetIntegrals& integrals);

}  // namespace bullet_buoyancy
