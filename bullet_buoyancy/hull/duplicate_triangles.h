#pragma once

#include <cstddef>

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// Keeps the first of triangles with the same three vertices in the same winding; returns how many it took
/// out. Patches of repeated triangles stay where taking them out would leave more edges with an odd number
/// of sides, as a surface with holes has them: there, solids share a face, and one of them may face inward.
/// Triangles of opposite winding are the two sides of a sheet, or of solids that touch, and stay.
std::size_t removeDuplicateTriangles(TriangleMesh& mesh);

}  // namespace bullet_buoyancy
