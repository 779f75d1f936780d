#include <LinearMath/btIDebugDraw.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/float_scene.h"

namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;

/// Notes what is drawn.
class Recorder : public btIDebugDraw {
public:
    struct Line {
        Vec3 from, to;
    };
    std::vector<Line> lines;
    std::vector<Vec3> spheres;

    void drawLine(const btVector3& from, const btVector3& to, const btVector3&) override {
        lines.push_back({toEigen(from), toEigen(to)});
    }
    void drawSphere(const btVector3& centre, btScalar, const btVector3&) override {
        spheres.push_back(toEigen(centre));
    }
    void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
    void reportErrorWarning(const char*) override {}
    void draw3dText(const btVector3&, const char*) override {}
    void setDebugMode(int) override {}
    int getDebugMode() const override { return DBG_DrawWireframe; }
};

Recorder draw(FloatScene& scene) {
    Recorder recorder;
    scene.buoyancy().debugDraw(&recorder);
    return recorder;
}

TEST(DebugDraw, ShowsWaterlineCentresAndForceOfAFloatingBox) {
    FloatScene scene;
    btRigidBody& box = scene.addFloatingBox({2, 2, 1}, 0.5, {});
    scene.run(2.0 / 60, 1.0 / 60);  // in its first step Bullet's body is where gravity alone took it
    const Recorder recorder = draw(scene);

    double waterline = 0, highest = -1;
    for (std::size_t i = 0; i + 1 < recorder.lines.size(); ++i) {
        const auto& [from, to] = recorder.lines[i];
        if (std::abs(from.z()) < 1e-6 && std::abs(to.z()) < 1e-6) waterline += (to - from).norm();
        highest = std::max({highest, from.z(), to.z()});
    }
    EXPECT_NEAR(waterline, 8, 1e-4);  // round the box
    EXPECT_LT(highest, 1e-6);         // only what is wet

    ASSERT_EQ(recorder.spheres.size(), 2u);
    EXPECT_LT((recorder.spheres[0] - scenes::poseOf(box).position).norm(), 1e-6);
    const double draft = 0.5 - scenes::poseOf(box).position.z();
    EXPECT_LT((recorder.spheres[1] - Vec3(0, 0, -draft / 2)).norm(), 1e-6);

    const auto& force = recorder.lines.back();
    EXPECT_LT((force.from - recorder.spheres[1]).norm(), 1e-6);
    EXPECT_NEAR(force.to.z() - force.from.z(), draft * 3,
                1e-5);  // of its diagonal of 3 the share that is wet
}

TEST(DebugDraw, ShowsOnlyTheCentreOfMassOfADryBody) {
    FloatScene scene;
    Pose high;
    high.position.z() = 50;
    scene.addFloatingBox({1, 1, 1}, 0.5, high);
    scene.step(1.0 / 60);
    const Recorder recorder = draw(scene);
    EXPECT_TRUE(recorder.lines.empty());
    EXPECT_EQ(recorder.spheres.size(), 1u);
}

TEST(DebugDraw, IsReachedThroughTheWorld) {
    FloatScene scene;
    scene.addFloatingBox({1, 1, 1}, 0.5, {});
    scene.step(1.0 / 60);
    Recorder recorder;
    scene.world().setDebugDrawer(&recorder);
    scene.world().debugDrawWorld();
    scene.world().setDebugDrawer(nullptr);
    EXPECT_GE(recorder.spheres.size(), 2u);
}

TEST(DebugDraw, ShowsTheWetPartOfSmoothSolids) {
    FloatScene scene;
    btRigidBody& ball = scene.addBody(std::make_unique<btSphereShape>(btScalar(0.5)), 200, Pose{});
    scene.buoyancy().addBody(ball);
    scene.step(1.0 / 60);
    double lowest = 0;
    for (const auto& line : draw(scene).lines)
        lowest = std::min(lowest, line.from.z());
    EXPECT_NEAR(lowest, -0.5, 0.02);  // a tessellated sphere
}

}  // namespace
}  // namespace bullet_buoyancy::test
