#include "scenes/boat_in_waves.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/interruption.h"

namespace bullet_buoyancy::scenes {

namespace {

struct Attitude {
    double roll, pitch, yaw;
};

/// See VoyageSample; Bullet's own axes would have the bow down.
Attitude attitudeOf(const Pose& pose) {
    const Mat3 turn = pose.worldFromBody();
    return {std::atan2(turn(2, 1), turn(2, 2)), std::asin(std::clamp(turn(2, 0), -1.0, 1.0)),
            std::atan2(turn(1, 0), turn(0, 0))};
}

}  // namespace

BoatInWaves::BoatInWaves(const Boat& boat, Sea& sea, const VoyageDef& def)
    : m_boat(boat), m_sea(sea), m_def(def), m_time(-def.settling), m_buoyancy(sea.water(), def.buoyancy) {
    m_world.setGravity({0, 0, btScalar(-standardGravity)});
    m_world.addAction(&m_buoyancy);
    m_buoyancy.setTime(m_time);
    placeBody();

    BodyDef body;
    body.hull = boat.hull;
    body.linearDrag = def.linearDrag;
    body.angularDamping = def.angularDamping;
    if (!m_buoyancy.addBody(*m_body, body)) m_mishap = Mishap::refused;
    const double wetAtRest = boat.displacement / boat.hull->moments.volume;
    m_pretension = -boat.mass * def.linearDrag * wetAtRest * sea.current();
}

BoatInWaves::~BoatInWaves() {
    m_world.removeRigidBody(m_body.get());
    m_world.removeAction(&m_buoyancy);
}

void BoatInWaves::placeBody() {
    m_sea.showAt(Vec2::Zero(), m_time);
    const double height = m_boat.heightAtRest + m_sea.elevation(Vec2::Zero(), m_time);
    m_shape = std::make_unique<btBoxShape>(toBullet(m_boat.size / 2));
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(m_boat.mass), nullptr, m_shape.get(),
                                                  toBullet(m_boat.inertia));
    info.m_startWorldTransform.setOrigin(toBullet(Vec3(0, 0, height)));
    m_body = std::make_unique<btRigidBody>(info);
    m_body->setActivationState(DISABLE_DEACTIVATION);
    m_world.addRigidBody(m_body.get());
}

/// A spring of the period T pulls with mass (2 pi / T)^2 a metre, and likewise it turns.
void BoatInWaves::pullMooring() {
    if (std::isinf(m_def.mooringPeriod)) return;
    const double rate = 2 * pi / m_def.mooringPeriod, perMass = rate * rate;
    const Pose now = pose();
    const Vec3 pull = m_pretension - m_boat.mass * perMass * Vec3(now.position.x(), now.position.y(), 0);
    m_body->applyCentralForce(toBullet(pull));
    m_body->applyTorque(toBullet(-m_boat.inertia.z() * perMass * attitudeOf(now).yaw * Vec3::UnitZ()));
}

void BoatInWaves::step() {
    pullMooring();
    m_time += m_def.step;
    // The action asks for the water at the end of the step.
    m_sea.showAt(pose().position.head<2>(), m_time);
    m_world.stepSimulation(btScalar(m_def.step), 0);
    look();
}

void BoatInWaves::look() {
    const BodyReport now = report();
    if (now.state == BodyState::notFinite || !pose().position.allFinite() ||
        !std::isfinite(now.totalEnergy()))
        m_mishap = Mishap::notFinite;
    else if (pose().worldFromBody()(2, 2) < 0)
        m_mishap = Mishap::capsized;
    m_underWater = now.state == BodyState::submerged ? m_underWater + m_def.step : 0;
    if (m_underWater > m_sea.def().period) m_mishap = Mishap::sunk;
}

Pose BoatInWaves::pose() const {
    return toPose(m_body->getWorldTransform());
}

double BoatInWaves::slopeAlong(const Pose& pose) const {
    const Vec2 place = pose.position.head<2>(), bow = pose.worldFromBody().col(0).head<2>().normalized();
    const double length = m_boat.size.x();
    const double rise =
        m_sea.elevation(place + length / 2 * bow, m_time) - m_sea.elevation(place - length / 2 * bow, m_time);
    return std::atan(rise / length);
}

VoyageSample BoatInWaves::sample() const {
    const Pose now = pose();
    const Attitude attitude = attitudeOf(now);
    return {m_time,
            m_sea.elevation(Vec2::Zero(), m_time),
            slopeAlong(now),
            now.position.x(),
            now.position.y(),
            now.position.z() - m_boat.heightAtRest,
            attitude.roll,
            attitude.pitch,
            attitude.yaw,
            report().forceErrorBound / (m_boat.mass * standardGravity),
            report().waterSamples};
}

Voyage sail(const Boat& boat, Sea& sea, const VoyageDef& def,
            const std::function<void(const BoatInWaves&, bool)>& look) {
    using Clock = std::chrono::steady_clock;
    BoatInWaves scene(boat, sea, def);
    const long settling = std::lround(def.settling / def.step), steps = std::lround(def.duration / def.step);
    Voyage voyage;
    voyage.samples.reserve(std::size_t(steps));
    const auto start = Clock::now();
    long taken = 0;
    for (long i = -settling; i < steps && scene.mishap() == Mishap::none && !isInterrupted(); ++i) {
        scene.step();
        ++taken;
        const bool isRecorded = i >= 0;
        if (isRecorded) voyage.samples.push_back(scene.sample());
        look(scene, isRecorded);
    }
    voyage.mishap = scene.mishap();
    voyage.clockPerStep = std::chrono::duration<double>(Clock::now() - start).count() / double(taken);
    return voyage;
}

std::vector<double> series(const Voyage& voyage, double VoyageSample::*quantity) {
    std::vector<double> values;
    values.reserve(voyage.samples.size());
    for (const VoyageSample& sample : voyage.samples)
        values.push_back(sample.*quantity);
    return values;
}

}  // namespace bullet_buoyancy::scenes
