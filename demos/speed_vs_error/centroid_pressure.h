#pragma once

#include "speed_vs_error/evaluators.h"

namespace bullet_buoyancy::demo {

/// The pressure at the centroid of each triangle times its area, if the centroid is under water; single
/// precision. Round solids as meshes.
std::unique_ptr<ReadyEvaluator> pressCentroids(const Hull& hull, const WaterField& water);

}  // namespace bullet_buoyancy::demo
