#include "bullet_buoyancy/bullet/buoyancy_action.h"

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/draw_floating_body.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"

namespace bullet_buoyancy {

namespace {

bool isInWorld(const btRigidBody& body, const btCollisionObjectArray& objects) {
    const int index = body.getWorldArrayIndex();
    return index >= 0 && index < objects.size() && objects[index] == &body;
}

/// Strength of the world's gravity against the water's up; none where it points up.
double gravityAlongDown(const btDynamicsWorld& world, const WaterFrame& frame) {
    return std::max(0.0, -toEigen(world.getGravity()).dot(frame.upWorld()));
}

}  // namespace

BuoyancyAction::BuoyancyAction(const WaterField& water, const BuoyancySettings& settings)
    : m_water(&water), m_settings(settings) {
    assert(std::isfinite(settings.tolerance) && settings.tolerance >= 0);
}

BodyStatus BuoyancyAction::addBody(btRigidBody& body, const BodyDef& def) {
    BodyStatus status = FloatingBody::check(body, def);
    if (m_index.count(&body)) status.error = BodyError::alreadyAdded;
    if (!status.ok()) return status;

    BodyDef complete = def;
    if (!complete.hull) {
        HullResult result = hullFromShape(*body.getCollisionShape());
        status.hull = result.status;
        if (!result.hull) {
            status.error = BodyError::badHull;
            return status;
        }
        complete.hull = std::move(result.hull);
    }
    m_index[&body] = m_bodies.size();
    m_bodies.emplace_back(body, complete);
    return status;
}

bool BuoyancyAction::removeBody(btRigidBody& body) {
    const auto entry = m_index.find(&body);
    if (entry == m_index.end()) return false;
    const std::size_t position = entry->second;
    m_bodies[position].giveBack();
    m_bodies.erase(m_bodies.begin() + std::ptrdiff_t(position));
    m_index.erase(entry);
    for (auto& [other, index] : m_index)
        if (index > position) --index;
    return true;
}

void BuoyancyAction::removeAllBodies() {
    for (FloatingBody& floating : m_bodies)
        floating.giveBack();
    m_bodies.clear();
    m_index.clear();
}

const BodyReport& BuoyancyAction::report(const btRigidBody& body) const {
    static const BodyReport unknown;
    const auto entry = m_index.find(&body);
    return entry == m_index.end() ? unknown : m_bodies[entry->second].report();
}

void BuoyancyAction::setTime(double time) {
    assert(std::isfinite(time));
    m_time = time;
    for (FloatingBody& floating : m_bodies)
        floating.forgetWaterAhead();
}

void BuoyancyAction::updateAction(btCollisionWorld* world, btScalar dt) {
    if (!(dt > 0) || !std::isfinite(dt)) {
        for (FloatingBody& floating : m_bodies)
            floating.skip(BodyState::badStep);
        return;
    }
    const auto& dynamicsWorld = *static_cast<btDynamicsWorld*>(world);  // the only worlds that have actions
    m_time += double(dt);
    const WaterNow water{*m_water, m_water->bounds(), gravityAlongDown(dynamicsWorld, m_water->frame()),
                         m_time, m_settings};
    for (FloatingBody& floating : m_bodies) {
        if (isInWorld(floating.body(), world->getCollisionObjectArray()))
            floating.step(water, double(dt));
        else
            floating.skip(BodyState::notInWorld);
    }
}

void BuoyancyAction::debugDraw(btIDebugDraw* drawer) {
    for (const FloatingBody& floating : m_bodies)
        if (floating.report().state != BodyState::notInWorld)
            drawFloatingBody(*drawer, floating, *m_water, m_time);
}

}  // namespace bullet_buoyancy
