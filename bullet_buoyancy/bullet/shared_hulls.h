#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <unordered_map>
#include <vector>

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy {

/// Hulls of collision shapes, each read once for all bodies that have the shape. A shape is known by its
/// address, so that a hull is shared only as long as a body that was given it still has the shape: without
/// such a witness another shape may lie there by now. A shape with another local scaling is read again.
class SharedHulls {
public:
    /// Of the body's collision shape (not null), as `hullFromShape`. The body must be forgotten before it is
    /// deleted. `outdated`: a hull that is no longer the shape's, whose inside has changed; may be null.
    HullResult of(const btRigidBody& body, const Hull* outdated = nullptr);

    /// `shape`: the body's when its hull was asked for; only its address is used.
    void forget(const btRigidBody& body, const btCollisionShape* shape);

    void forgetAll() { m_known.clear(); }

private:
    struct Known {
        std::shared_ptr<const Hull> hull;
        HullStatus status;
        btVector3 scaling;
        std::vector<const btRigidBody*> witnesses;
    };

    std::unordered_map<const btCollisionShape*, Known> m_known;
};

}  // namespace bullet_buoyancy
