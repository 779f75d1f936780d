#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy {

/// Reads a collision shape as what the water wets, in the shape's frame: its visible, nominal geometry with
/// local scaling, without Bullet's collision margins (a box's margin is part of the box).
///
/// Box, convex hull, other convex polyhedra, triangle meshes (convex, BVH, scaled BVH, GImpact) and compounds
/// of anything here are read as triangles; sphere, capsule, cylinder, cone, and multi-spheres that are a
/// sphere or a tapered capsule, as true solids. Other multi-spheres, and Minkowski sums (Bullet's are A - B)
/// with smooth members, are tessellated; `HullStatus::tessellationError` tells how roughly. Planes,
/// heightfields, empty, 2D and soft shapes are refused, with the reason.
HullResult hullFromShape(const btCollisionShape& shape);

}  // namespace bullet_buoyancy
