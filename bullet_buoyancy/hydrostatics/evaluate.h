#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// The cheapest of the evaluators for that hull, water and tolerance: what the action uses.
HydrostaticResult evaluate(const Hull& hull, const Pose& pose, const WaterField& water,
                           const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
