#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// In closed form.
Displacement displacementOf(const Sphere& sphere, const WaterPlane& plane);

/// Adds what the water does to a sphere, in closed form.
void addSphere(const Sphere& sphere, const WaterPlane& plane, const HydrostaticQuery& query,
               WetIntegrals& integrals);

/// Adds what the water does to a solid of revolution: where its sections are wholly wet by polynomials, where
/// the surface cuts them by circular segments and Gauss quadrature along the axis.
void addSolid(const SolidOfRevolution& solid, const WaterPlane& plane, const HydrostaticQuery& query,
              WetIntegrals& integrals);

}  // namespace bullet_buoyancy
