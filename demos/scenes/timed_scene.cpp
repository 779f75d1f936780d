#include "scenes/timed_scene.h"

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/crowd_pose.h"
#include "scenes/solids.h"
#include "scenes/study_hulls.h"

namespace bullet_buoyancy::scenes {

namespace {

std::unique_ptr<btCollisionShape> makePointsHull() {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const Vec3& vertex : pointsHull(32).vertices)
        shape->addPoint(toBullet(vertex));
    return shape;
}

std::unique_ptr<btCollisionShape> makeMixed(int kind) {
    switch (kind) {
        case 0:
            return makeShape(Solid::sphere, {1, 1, 1});
        case 1:
            return makeShape(Solid::capsule, {0.6, 0.6, 0.6});
        case 2:
            return makeShape(Solid::cylinder, {0.8, 1, 0.8});
        case 3:
            return makePointsHull();
        default:
            return makeShape(Solid::box, {1, 0.8, 0.6});
    }
}

}  // namespace

std::vector<NamedShapes> shapesOfScenes() {
    return {{"boxes", 1,
             [](int) {
                 return makeShape(Solid::box, {1, 0.8, 0.6});
             }},
            {"boxes, hulls, round ones", 5, makeMixed}};
}

TimedScene::TimedScene(const NamedShapes& shapes, int bodies, double (*clock)()) : m_clock(clock) {
    constexpr double distance = 4, spread = 0.2, ratio = 0.5;
    std::vector<BodyDef> defs(std::size_t(shapes.kinds));
    for (int i = 0; i < bodies; ++i) {
        const int kind = i % shapes.kinds;
        auto shape = shapes.makeShape(kind);
        BodyDef& def = defs[std::size_t(kind)];
        if (!def.hull) def.hull = hullFromShape(*shape).hull;
        const double mass = ratio * m_scene.water().density() * def.hull->moments.volume;
        m_scene.floatBody(m_scene.addBody(std::move(shape), mass, crowdPose(i, distance, spread)), def);
    }
    m_scene.world().removeAction(&m_scene.floater());
    m_scene.world().addAction(&m_stopwatch);
}

TimedScene::~TimedScene() {
    m_scene.world().removeAction(&m_stopwatch);
    m_scene.world().addAction(&m_scene.floater());
}

SubstepTime TimedScene::step() {
    m_stopwatch.reset();
    const double start = m_clock();
    m_scene.step(1.0 / 60);
    return {(m_clock() - start) * 1e9, m_stopwatch.median()};
}

}  // namespace bullet_buoyancy::scenes
