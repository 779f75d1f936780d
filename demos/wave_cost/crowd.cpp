#include "wave_cost/crowd.h"

#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"

namespace bullet_buoyancy::demo {

namespace {

constexpr double dt = 1.0 / 60, distance = 4;  // s, m
constexpr int bodiesInARow = 32;

double elevationAt(const WaterField& water, double x, double y) {
    Eigen::ArrayX2d point(1, 2);
    point << x, y;
    Eigen::ArrayX3d surface(1, 3);
    water.sampleSurface(point, 0, surface);
    return surface(0, 0);
}

}  // namespace

Crowd::Crowd(const WaterField& water, const BuoyancySettings& settings, int count)
    : m_water(water), m_settings(settings), m_action(water, settings) {
    m_scene.world().removeAction(&m_scene.floater());
    m_scene.world().addAction(&m_stopwatch);
    const Vec3 size = Vec3::Ones();
    BodyDef def;
    for (int i = 0; i < count; ++i) {
        const double x = distance * (i % bodiesInARow), y = distance * (i / bodiesInARow);
        Pose pose;
        // Each at another height and heel, so that nothing can be learnt by heart.
        pose.position = {x, y, elevationAt(water, x, y) + 0.2 * std::sin(i)};
        pose.orientation = Eigen::AngleAxisd(0.2 * std::sin(3 * i), Vec3(std::cos(i), std::sin(i), 0));
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

double Crowd::step(int steps) {
    m_stopwatch.reset();
    for (int i = 0; i < steps; ++i)
        m_scene.step(dt);
    return m_stopwatch.median() / double(m_bodies.size());
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
        sink = evaluateExact(*m_hull, pose, m_water, query).forceWorld.z();
    static_cast<void>(sink);
    return (scenes::processorTime() - start) * 1e9 / double(poses.size());
}

double Crowd::samples() const {
    double sum = 0;
    for (const btRigidBody* body : m_bodies)
        sum += evaluateExact(*m_hull, scenes::poseOf(*body), m_water, query()).waterSamples;
    return sum / double(m_bodies.size());
}

double Crowd::evaluations() const {
    double sum = 0;
    for (const btRigidBody* body : m_bodies)
        sum += m_action.report(*body).evaluations;
    return sum / double(m_bodies.size());
}

}  // namespace bullet_buoyancy::demo
