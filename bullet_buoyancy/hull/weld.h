#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

struct WeldCounts {
    std::size_t removedVertices = 0;
    std::size_t removedTriangles = 0;
};

/// Makes one vertex of those within `tolerance` (m) of each other, takes out triangles that lose a corner by
/// it and vertices that no triangle uses. Indices must be in range and coordinates finite.
WeldCounts weld(TriangleMesh& mesh, double tolerance);

}  // namespace bullet_buoyancy
