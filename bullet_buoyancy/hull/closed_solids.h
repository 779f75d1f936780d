#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// The solids of an oriented mesh whose shells are given by their triangles: every closed shell that faces
/// outward, with the closed shells that face inward (cavities) of which it is the smallest to enclose them.
/// Open and flat shells bound nothing.
std::vector<TriangleMesh> closedSolids(const TriangleMesh& mesh,
                                       const std::vector<std::vector<std::uint32_t>>& shells);

}  // namespace bullet_buoyancy
