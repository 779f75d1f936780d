#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// How many times the surface winds round a point: 1 inside a closed outward surface, 0 outside, fractions
/// near the holes of an open one (Jacobson, Kavan and Sorkine-Hornung 2013; solid angles after van Oosterom
/// and Strackee 1983).
double windingNumber(const TriangleMesh& mesh, const Vec3& point);

}  // namespace bullet_buoyancy
