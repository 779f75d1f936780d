#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy::scenes {

enum class Solid {
    box,
    sphere,    ///< of the diameter size.x
    capsule,   ///< of the diameter size.x, and size.y between the centres of its caps, along y
    cylinder,  ///< of the diameter size.x, size.y long, along y
};

std::unique_ptr<btCollisionShape> makeShape(Solid solid, const Vec3& size);

/// m^3
double volumeOf(Solid solid, const Vec3& size);

}  // namespace bullet_buoyancy::scenes
