#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// The convex hull of points (finite: asserted) as a closed mesh that faces outward. Points within
/// about `convexHullTolerance` of the cloud's size from the hull of the others may be left out. No triangles
/// if the points lie in one plane to that tolerance. Quickhull (Barber, Dobkin and Huhdanpaa 1996).
TriangleMesh convexHull(const std::vector<Vec3>& points);

}  // namespace bullet_buoyancy
