#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"
#include "bullet_buoyancy/hydrostatics/mesh_sum.h"

namespace bullet_buoyancy {

/// The way that all evaluators but the reference go.
HydrostaticResult evaluateHull(const Hull& hull, const Pose& pose, const WaterField& water,
                               const HydrostaticQuery& query, MeshSum sum);

}  // namespace bullet_buoyancy
