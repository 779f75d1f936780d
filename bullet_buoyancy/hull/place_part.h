#pragma once

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy {

/// The part scaled by `scale` about its origin (mirrored there if that is below 0: a mesh is then inside
/// out), then turned and moved by `pose`.
HullPart placed(const HullPart& part, const Pose& pose, double scale = 1);

}  // namespace bullet_buoyancy
