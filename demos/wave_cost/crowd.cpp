#include "wave_cost/crowd.h"

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "scenes/crowd_pose.h"
#include "scenes/study_cases.h"

namespace bullet_buoyancy::demo {

namespace {

constexpr double dt = 1.0 / 60, distance = 4;  // s, m

}  // namespace

Crowd::Crowd(const WaterField& water, const BuoyancySettings& settings, int count)
    : m_water(water), m_settings(settings), m_action(water, settings) {
    m_scene.world().removeAction(&m_scene.floater());
    m_scene.world().addAction(&m_stopwatch);
    const Vec3 size = Vec3::Ones();
    BodyDef def;
    for (int i = 0; i < count; ++i) {
        Pose pose = scenes::crowdPose(i, distance, 0.2);
        pose.position.z() += scenes::elevationAt(water, pose.position.head<2>(), 0);
        auto shape = std::make_unique<btBoxShape>(toBullet(size / 2));
        if (!def.hull) def.hull = hullFromShape(*shape).hull;
        btRigidBody& body = m_scene.addBody(std::move(shape), 0.5 * water.density() * size.prod(), pose);
        m_action.addBody(body, def);
        m_bodies.push_back(&body);
    }
    m_hull = def.hull;
}

Crowd::~Crowd() {
    m_scene.world().removeAction(&m_stopwatch);
    m_scene.world().addAction(&m_scene.floater());
}

scenes::SubstepTime Crowd::step(int steps) {
    m_stopwatch.reset();
    const double start = scenes::processorTime();
    for (int i = 0; i < steps; ++i)
        m_scene.step(dt);
    const double whole = (scenes::processorTime() - start) * 1e9 / steps, bodies = double(m_bodies.size());
    return {whole / bodies, m_stopwatch.median() / bodies};
}

HydrostaticQuery Crowd::query() const {
    HydrostaticQuery query;
    query.time = m_action.time();
    query.pressure = m_settings.pressure;
    query.tolerance = m_settings.tolerance;
    return query;
}

double Crowd::evaluate() const {
    std::vector<Pose> poses;
    for (const btRigidBody* body : m_bodies)
        poses.push_back(scenes::poseOf(*body));
    const HydrostaticQuery query = this->query();
    volatile double sink = 0;  // so that no evaluation is optimized away
    const double start = scenes::processorTime();
    for (const Pose& pose : poses)
        sink = bullet_buoyancy::evaluate(*m_hull, pose, m_water, query).forceWorld.z();
    static_cast<void>(sink);
    return (scenes::processorTime() - start) * 1e9 / double(poses.size());
}

double Crowd::samples() const {
    double sum = 0;
    for (const btRigidBody* body : m_bodies)
        sum += bullet_buoyancy::evaluate(*m_hull, scenes::poseOf(*body), m_water, query()).waterSamples;
    return sum / double(m_bodies.size());
}

double Crowd::evaluations() const {
    double sum = 0;
    for (const btRigidBody* body : m_bodies)
        sum += m_action.report(*body).evaluations;
    return sum / double(m_bodies.size());
}

}  // namespace bullet_buoyancy::demo
