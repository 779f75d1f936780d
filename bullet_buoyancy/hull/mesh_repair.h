#pragma once

#include <vector>

#include "bullet_buoyancy/hull/hull_status.h"
#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// What was found in a mesh, and what was done about it.
struct MeshFindings {
    HullError error = HullError::none;  ///< `notFinite` or `badIndices`: the mesh was left as it is
    std::size_t weldedVertices = 0;     ///< vertices that repeated another one, or that no triangle used
    std::size_t degenerateTriangles =
        0;                               ///< triangles with two corners in one point: without area, taken out
    std::size_t duplicateTriangles = 0;  ///< triangles that repeated another one, taken out
    std::size_t flippedTriangles = 0;    ///< triangles that faced inward, turned round
    std::size_t openEdges = 0;           ///< edges whose triangles do not balance: 0 means a closed surface
    std::vector<std::vector<std::uint32_t>> shells;  ///< triangles of each piece that hangs together
};

/// Makes one vertex of those within `weldTolerance` of the mesh's size, takes out triangles that collapse by
/// it or that repeat another one, makes neighbours agree in their winding, and turns every outermost shell
/// outward, together with what lies within it: a shell inside another that faces the other way bounds a
/// cavity.
MeshFindings repairMesh(TriangleMesh& mesh);

/// Length of the diagonal of the vertices' bounding box, m; 0 without vertices.
double meshSize(const TriangleMesh& mesh);

}  // namespace bullet_buoyancy
