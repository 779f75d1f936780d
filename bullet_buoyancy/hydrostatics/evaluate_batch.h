#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// As `evaluateExact`, but the triangles of a closed mesh are summed up sixteen at a time by the widest
/// vector instructions of the machine: in the query's precision where the water about the hull is a plane, or
/// near enough to one for the tolerance. Its sums are the same on every machine, to the last bit.
HydrostaticResult evaluateBatch(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
