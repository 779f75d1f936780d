#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy::demo {

/// The points of a grid over the mesh's box, `pointsAlong` each of its edges, that a closed mesh encloses.
std::vector<Vec3> pointsInside(const TriangleMesh& mesh, int pointsAlong);

}  // namespace bullet_buoyancy::demo
