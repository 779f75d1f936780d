#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// The truth to measure evaluators against: slow, in double precision, and from the other side of Gauss's
/// theorem.
///
/// Closed meshes: Archimedes on the displaced volume, as signed tetrahedra clipped at the surface, the
/// waterplane from its outline; exact but for rounding. Open meshes: pressure over adaptively quartered
/// triangles, to 1e-7 of the weight of water in the bounding box. Solids: pressure over their curved surface,
/// by Gauss quadrature along the axis and round the wet arc, to 1e-8. Same arguments and result as
/// `evaluateExact`.
HydrostaticResult evaluateReference(const Hull& hull, const Pose& pose, const WaterField& water,
                                    const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
