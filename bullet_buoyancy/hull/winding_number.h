#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// How many times the surface winds round a point: 1 inside a closed outward surface, 0 outside, fractions
/// near the holes of an open one (Jacobson, Kavan and Sorkine-Hornung 2013; solid angles after van Oosterom
/// and Strackee 1983).
double windingNumber(const TriangleMesh& mesh, const Vec3& point);

/// Whether most of a surface lies within another one, whichever way that faces: asked at up to 32 centroids.
bool encloses(const TriangleMesh& outer, const TriangleMesh& inner);

}  // namespace bullet_buoyancy
