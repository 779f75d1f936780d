#pragma once

#include <cmath>

#include "bullet_buoyancy/hull/tessellate.h"

namespace bullet_buoyancy::test {

/// A closed surface of 20 * 4^level triangles about an ellipsoid of half axes 1, 0.7 and 0.5 m, away from
/// the body's origin, with bumps, neither convex nor symmetric.
inline TriangleMesh bumpyMesh(int level) {
    TriangleMesh mesh = tessellate(Sphere{Vec3::Zero(), 1}, level);
    for (Vec3& v : mesh.vertices) {
        const double bump = 1 + 0.05 * std::sin(5 * v.x() + 1) * std::cos(4 * v.y());
        v = bump * v.cwiseProduct(Vec3(1, 0.7, 0.5)) + Vec3(0.3, -0.2, 0.1);
    }
    return mesh;
}

}  // namespace bullet_buoyancy::test
