#pragma once

#include "speed_vs_error/evaluators.h"

namespace bullet_buoyancy::demo {

/// The closed form as one would first write it, and the yardstick: a plain loop over the triangles of an
/// indexed mesh, each clipped where depth passes through zero, the linear pressure on the wet part integrated
/// exactly, all in single precision. Round solids as meshes.
std::unique_ptr<ReadyEvaluator> closedFormInFloat(const Hull& hull, const WaterField& water);

}  // namespace bullet_buoyancy::demo
