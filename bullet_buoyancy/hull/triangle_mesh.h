#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// Indices of three vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// Indexed triangles in a body's frame. Counter-clockwise seen from outside: (b - a) x (c - a) points into
/// the water.
struct TriangleMesh {
    std::vector<Vec3> vertices;       ///< m
    std::vector<Triangle> triangles;  ///< indices into `vertices`
};

}  // namespace bullet_buoyancy
