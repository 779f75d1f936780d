#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// As `evaluateExact`, but where the water about a hull is a plane the triangles of a closed mesh are summed
/// up sixteen at a time by the widest vector instructions of the machine, in the query's precision. The
/// result is the same on every machine, to the last bit. Elsewhere in waves closed or open meshes go the way
/// of `evaluateClustered`, in full precision.
HydrostaticResult evaluateBatch(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
