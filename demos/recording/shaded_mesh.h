#pragma once

#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy::recording {

/// Triangles with a normal at each vertex: where a surface has an edge, a vertex stands once for each side.
struct ShadedMesh {
    std::vector<Vec3> vertices;  ///< m
    std::vector<Vec3> normals;   ///< unit length, outward
    std::vector<Triangle> triangles;
};

/// All of a hull as triangles, in its own frame: of a sphere or a solid of revolution those of a closed mesh
/// with its vertices on the solid.
TriangleMesh trianglesOf(const Hull& hull);

/// Edges at which the surface turns by more than `crease` (rad) are sharp, the others smooth.
ShadedMesh shade(const TriangleMesh& mesh, double crease = 0.7);

}  // namespace bullet_buoyancy::recording
