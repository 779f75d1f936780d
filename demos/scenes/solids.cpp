#include "scenes/solids.h"

#include <btBulletDynamicsCommon.h>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy::scenes {

std::unique_ptr<btCollisionShape> makeShape(Solid solid, const Vec3& size) {
    const btVector3 half = toBullet(size / 2);
    switch (solid) {
        case Solid::sphere:
            return std::make_unique<btSphereShape>(half.x());
        case Solid::capsule:
            return std::make_unique<btCapsuleShape>(half.x(), 2 * half.y());
        case Solid::cylinder:
            return std::make_unique<btCylinderShape>(btVector3(half.x(), half.y(), half.x()));
        case Solid::box:
            break;
    }
    return std::make_unique<btBoxShape>(half);
}

double volumeOf(Solid solid, const Vec3& size) {
    const double disc = pi / 4 * size.x() * size.x(), sphere = pi / 6 * size.x() * size.x() * size.x();
    switch (solid) {
        case Solid::sphere:
            return sphere;
        case Solid::capsule:
            return sphere + disc * size.y();
        case Solid::cylinder:
            return disc * size.y();
        case Solid::box:
            break;
    }
    return size.prod();
}

}  // namespace bullet_buoyancy::scenes
