#pragma once

#include <vector>

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy::demo {

/// A hull seen from the side: the convex outline of its x and z, counter-clockwise, m.
std::vector<Vec2> profileOf(const TriangleMesh& mesh);

/// What of a convex outline is not above a height (m).
std::vector<Vec2> below(const std::vector<Vec2>& outline, double height);

}  // namespace bullet_buoyancy::demo
