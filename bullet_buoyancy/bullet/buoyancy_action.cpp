#include "bullet_buoyancy/bullet/buoyancy_action.h"

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>
#include <LinearMath/btThreads.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bullet_buoyancy/bullet/calm_block.h"
#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/draw_floating_body.h"

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

/// Asks for a body that will be stepped soon: Bullet's lie scattered.
void prefetch([[maybe_unused]] const btRigidBody& body) {
#ifdef __GNUC__
    constexpr std::size_t line = 64, most = 16 * line;  // behind them is what solvers alone work with
    for (std::size_t offset = 0; offset < std::min(sizeof(btRigidBody), most); offset += line)
        __builtin_prefetch(reinterpret_cast<const char*>(&body) + offset);
#endif
}

/// One substep of any of the bodies, which know nothing of each other.
class Substep final : public btIParallelForBody {
public:
    Substep(std::vector<FloatingBody>& bodies, const btCollisionObjectArray& objects, const WaterNow& water,
            double dt)
        : m_bodies(bodies), m_objects(objects), m_water(water), m_dt(dt) {}

    void forLoop(int begin, int end) const override {
        const bool mayBeCalm = CalmBlock::isFor(m_water);
        CalmBlock block(m_water, m_dt);
        for (int i = begin; i < end; ++i) {
            if (i + 1 < end) prefetch(m_bodies[std::size_t(i + 1)].body());
            FloatingBody& floating = m_bodies[std::size_t(i)];
            if (!isInWorld(floating.body(), m_objects))
                floating.skip(BodyState::notInWorld);
            else if (mayBeCalm && floating.isAtEase(m_water, m_dt))
                block.add(floating);
            else
                floating.step(m_water, m_dt);
        }
        block.step();
    }

private:
    std::vector<FloatingBody>& m_bodies;
    const btCollisionObjectArray& m_objects;
    const WaterNow& m_water;
    double m_dt;
};

/// By the scheduler that the user has given Bullet, if any. It is asked itself: `btParallelFor` asks it only
/// where Bullet was built thread-safe, which bodies that know nothing of each other do not need.
void stepAll(const Substep& substep, int count) {
    constexpr int grain = 32;  // bodies, some 10 us: far more than it takes to hand them to a thread
    btITaskScheduler* scheduler = btGetTaskScheduler();
    if (scheduler && count > grain)
        scheduler->parallelFor(0, count, grain, substep);
    else
        substep.forLoop(0, count);
}

}  // namespace

BuoyancyAction::BuoyancyAction(const WaterField& water, const BuoyancySettings& settings)
    : m_water(&water), m_settings(settings) {
    assert(std::isfinite(settings.tolerance) && settings.tolerance >= 0);
}

BodyStatus BuoyancyAction::addBody(btRigidBody& body, const BodyDef& def) {
    BodyStatus status = FloatingBody::check(body, def);
    if (m_index.count(&body))
        status.error = BodyError::alreadyAdded;
    else if (status.ok() && isTaken(def.id))
        status.error = BodyError::idTaken;
    if (!status.ok()) return status;

    BodyDef complete = def;
    if (!complete.hull) complete.hull = shapesHull(body, nullptr, status);
    if (!status.ok()) return status;
    m_index[&body] = m_bodies.size();
    m_bodies.emplace_back(body, complete);
    return status;
}

BodyStatus BuoyancyAction::updateHull(btRigidBody& body, std::shared_ptr<const Hull> hull) {
    FloatingBody* floating = find(body);
    BodyStatus status = FloatingBody::checkHull(body, hull.get());
    if (!floating) status.error = BodyError::notAdded;
    if (!status.ok()) return status;

    const bool isGiven = hull != nullptr;
    if (!isGiven) hull = shapesHull(body, &floating->hull(), status);
    if (!status.ok()) return status;
    if (isGiven || body.getCollisionShape() != floating->knownShape())
        m_hulls.forget(body, floating->knownShape());
    floating->changeHull(std::move(hull));
    return status;
}

/// Null, with the error, where it is refused.
std::shared_ptr<const Hull> BuoyancyAction::shapesHull(const btRigidBody& body, const Hull* outdated,
                                                       BodyStatus& status) {
    HullResult result = m_hulls.of(body, outdated);
    status.hull = result.status;
    if (!result.hull) status.error = BodyError::badHull;
    return std::move(result.hull);
}

FloatingBody* BuoyancyAction::find(const btRigidBody& body) {
    const auto entry = m_index.find(&body);
    return entry == m_index.end() ? nullptr : &m_bodies[entry->second];
}

bool BuoyancyAction::isTaken(std::uint64_t id) const {
    return id != 0 && std::any_of(m_bodies.begin(), m_bodies.end(),
                                  [id](const FloatingBody& floating) { return floating.id() == id; });
}

bool BuoyancyAction::removeBody(btRigidBody& body) {
    const auto entry = m_index.find(&body);
    if (entry == m_index.end()) return false;
    const std::size_t position = entry->second;
    m_bodies[position].giveBack();
    m_hulls.forget(body, m_bodies[position].knownShape());
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
    m_hulls.forgetAll();
}

BodyReport BuoyancyAction::report(const btRigidBody& body) const {
    const auto entry = m_index.find(&body);
    return entry == m_index.end() ? BodyReport() : m_bodies[entry->second].report(m_water->frame());
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
    stepAll({m_bodies, world->getCollisionObjectArray(), water, double(dt)}, int(m_bodies.size()));
}

void BuoyancyAction::debugDraw(btIDebugDraw* drawer) {
    for (const FloatingBody& floating : m_bodies)
        if (floating.state() != BodyState::notInWorld) drawFloatingBody(*drawer, floating, *m_water, m_time);
}

}  // namespace bullet_buoyancy
