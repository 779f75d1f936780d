#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <unordered_map>

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy {

/// Hulls of collision shapes, each read once for all bodies that have the shape, for as long as one of them
/// is there. A shape with another local scaling is read again.
class SharedHulls {
public:
    /// As `hullFromShape`.
    HullResult of(const btCollisionShape& shape);

private:
    struct Known {
        std::weak_ptr<const Hull> hull;
        HullStatus status;
        btVector3 scaling;
    };
    void forgetWhatIsGone();

    std::unordered_map<const btCollisionShape*, Known> m_known;
    std::size_t m_nextLook = 16;  // entries at which to look for those that are gone
};

}  // namespace bullet_buoyancy
