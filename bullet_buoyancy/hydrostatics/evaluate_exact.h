#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// The law: every triangle clipped at the surface and its linear pressure integrated exactly; spheres in
/// closed form; solids of revolution by circular segments along the axis, volume and moments to 2e-8 of
/// theirs, areas to 1e-5 of the square of their size.
///
/// In waves the surface and head about the hull are taken to second order in each cell of its box, as many
/// cells as `query.tolerance` asks for, however fine the mesh: what the water tells of its derivatives
/// (`WaterField`) bounds the error, `forceErrorBound`. Closed hulls for which a plane is near enough to the
/// water are evaluated under that. Where waves are too short for the hull even so (256 cells at most), the
/// bound is above the tolerance. With a tolerance of 0 the water is sampled at every corner of every triangle
/// and taken for linear in between. The stiffness leaves out the bend of the surface.
///
/// Works in the body's frame, so that distance from the world's origin costs no accuracy. A hull that is
/// wholly dry costs constant time, and so does one that lies wholly under water, but for open edges and waves
/// that are short against it.
HydrostaticResult evaluateExact(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
