#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// The same cube (1 m, half as dense as water, let go askew above it, damped) in two surroundings: largest
/// difference of its height above the water over `seconds`, m.
double differenceOfUps(const Vec3& upWorld, double seconds, Floater floater, const Stepping& stepping = {});

/// Without gravity: how far a cube at rest in water, and one above it, get in 5 s, m.
double driftWithoutGravity(Floater floater, const Stepping& stepping = {});

/// A slab, 2 by 2 by 1 m and half as dense as water, heaves for 5 s without friction, let go 0.1 m above its
/// draft: largest difference between steps of `dt` (s) and the same cut into eight substeps, m.
double differenceOfSubsteps(double dt, Floater floater);

}  // namespace bullet_buoyancy::scenes
