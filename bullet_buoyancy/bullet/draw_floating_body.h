#pragma once

#include <LinearMath/btIDebugDraw.h>

#include "bullet_buoyancy/bullet/floating_body.h"

namespace bullet_buoyancy {

/// Draws the waterline, straight across each triangle, the wetted part of it, the centres of mass (yellow)
/// and buoyancy (cyan), and the force of the water as an arrow of the body's length for a force of its whole
/// hull's displacement. May allocate.
void drawFloatingBody(btIDebugDraw& drawer, const FloatingBody& floating, const WaterField& water,
                      double time);

}  // namespace bullet_buoyancy
