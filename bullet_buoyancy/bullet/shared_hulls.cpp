#include "bullet_buoyancy/bullet/shared_hulls.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>

#include "bullet_buoyancy/bullet/hull_from_shape.h"

namespace bullet_buoyancy {

namespace {

using Bodies = std::vector<const btRigidBody*>;

/// Those found to have another shape are dropped.
bool anyHas(const btCollisionShape& shape, Bodies& witnesses) {
    while (!witnesses.empty() && witnesses.back()->getCollisionShape() != &shape)
        witnesses.pop_back();
    return !witnesses.empty();
}

}  // namespace

HullResult SharedHulls::of(const btRigidBody& body, const Hull* outdated) {
    const btCollisionShape& shape = *body.getCollisionShape();
    const auto entry = m_known.find(&shape);
    if (entry != m_known.end()) {
        Known& known = entry->second;
        if (known.hull.get() != outdated && known.scaling == shape.getLocalScaling() &&
            anyHas(shape, known.witnesses)) {
            known.witnesses.push_back(&body);
            return {known.hull, known.status};
        }
    }
    HullResult result = hullFromShape(shape);
    if (result.hull) m_known[&shape] = {result.hull, result.status, shape.getLocalScaling(), {&body}};
    return result;
}

void SharedHulls::forget(const btRigidBody& body, const btCollisionShape* shape) {
    const auto entry = m_known.find(shape);
    if (entry == m_known.end()) return;
    Bodies& witnesses = entry->second.witnesses;
    witnesses.erase(std::remove(witnesses.begin(), witnesses.end(), &body), witnesses.end());
    if (witnesses.empty()) m_known.erase(entry);
}

}  // namespace bullet_buoyancy
