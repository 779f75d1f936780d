#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// The law: every triangle clipped at the surface and its linear pressure integrated exactly; spheres in
/// closed form; solids of revolution by circular segments along the axis, volume and moments to 2e-8 of
/// theirs, areas to 1e-5 of the square of their size.
///
/// Works in the body's frame, so that distance from the world's origin costs no accuracy. Water must be flat
/// (see `waterPlaneInBody`). A hull that is wholly dry or, without open edges, wholly wet costs constant
/// time.
HydrostaticResult evaluateExact(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
