#pragma once

#include "bullet_buoyancy/hull/solid_of_revolution.h"
#include "bullet_buoyancy/hull/sphere.h"

namespace bullet_buoyancy {

/// A closed mesh with its vertices on the sphere: an icosahedron whose triangles are quartered `levels` times
/// (20 * 4^levels triangles).
TriangleMesh tessellate(const Sphere& sphere, int levels);

/// A closed mesh with its vertices on the solid: `segments` meridians, and as many rings a quarter turn of
/// the profile.
TriangleMesh tessellate(const SolidOfRevolution& solid, int segments);

}  // namespace bullet_buoyancy
