// The snippets of the guide "Float a crate".

// [snippet]
#include <btBulletDynamicsCommon.h>
#include <bullet_buoyancy/bullet_buoyancy.h>
// [end]

#include <gtest/gtest.h>

#include <cstdio>

namespace {

/// The body must displace its weight to this share: what Bullet's sleep takes for balance.
constexpr double balance = 2e-4;

TEST(FloatACrate, FloatsAsTheGuideSays) {
    // [snippet]
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, -9.81f, 0));

    btBoxShape box(btVector3(0.6f, 0.3f, 0.4f));  // half of 1.2 m x 0.6 m x 0.8 m
    const btScalar mass = 240;                    // kg
    btVector3 inertia;
    box.calculateLocalInertia(mass, inertia);
    btRigidBody crate(mass, nullptr, &box, inertia);
    crate.setWorldTransform(btTransform(btQuaternion(btVector3(0, 0, 1), 0.3f), btVector3(0, 2, 0)));
    world.addRigidBody(&crate);
    // [end]

    // [snippet]
    bullet_buoyancy::FlatWater sea(bullet_buoyancy::WaterFrame::yUp());  // its surface is y = 0
    bullet_buoyancy::BuoyancyAction buoyancy(sea);
    world.addAction(&buoyancy);

    const bullet_buoyancy::BodyStatus status = buoyancy.addBody(crate);
    std::puts(status.describe().c_str());  // "ok", remarks about the hull, or why not
    // [end]
    EXPECT_EQ(status.describe(), "ok");

    // [snippet]
    for (int frame = 0; frame < 30 * 60; ++frame)
        world.stepSimulation(1 / 60.f);
    // [end]

    testing::internal::CaptureStdout();
    // [snippet]
    const bullet_buoyancy::BodyReport report = buoyancy.report(crate);
    std::printf("its centre is at %.3f m\n", double(crate.getWorldTransform().getOrigin().y()));
    std::printf("%.3f m^3 of it are under water\n", report.submergedVolume);
    std::printf("the water lifts it by %.2f kN\n", double(report.forceWorld.y()) / 1000);
    // [end]
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "its centre is at 0.050 m\n"
              "0.240 m^3 of it are under water\n"
              "the water lifts it by 2.35 kN\n");
    EXPECT_NEAR(report.submergedVolume, 0.24, 0.24 * balance);
    EXPECT_NEAR(report.wetFraction, 0.24 / 0.576, balance);

    // [snippet]
    world.removeAction(&buoyancy);
    buoyancy.removeBody(crate);
    world.removeRigidBody(&crate);
    // [end]
    EXPECT_EQ(buoyancy.bodyCount(), 0u);
}

TEST(FloatACrate, RunsInOtherWaterToo) {
    // [snippet]
    bullet_buoyancy::FlatWaterDef def;
    def.density = bullet_buoyancy::seaWaterDensity;  // 1026 kg/m^3
    def.flowVelocityWorld = {0.5, 0, 0};             // m/s
    bullet_buoyancy::FlatWater river(bullet_buoyancy::WaterFrame::zUp({0, 0, 12}), def);
    // [end]
    EXPECT_EQ(river.density(), 1026);
    EXPECT_EQ(river.frame().pointFromWorld({1, 2, 13}), bullet_buoyancy::Vec3(1, 2, 1));
}

TEST(FloatACrate, TakesAHullOfOnesOwn) {
    btBoxShape box(btVector3(2, 1, 1));
    const btScalar mass = 1000;
    btVector3 inertia;
    box.calculateLocalInertia(mass, inertia);
    btRigidBody boat(mass, nullptr, &box, inertia);
    const bullet_buoyancy::FlatWater sea(bullet_buoyancy::WaterFrame::yUp());
    bullet_buoyancy::BuoyancyAction buoyancy(sea);
    // [snippet]
    // A wedge 4 m long, 2 m wide and 1 m high: a hull for a box that only collides.
    const bullet_buoyancy::TriangleMesh wedge = bullet_buoyancy::convexHull(
        {{-2, -0.7, 0}, {2, -0.7, 0}, {-2, 0.3, -1}, {-2, 0.3, 1}, {2, 0.3, -1}, {2, 0.3, 1}});
    const bullet_buoyancy::HullResult made = bullet_buoyancy::makeHull(wedge);
    std::puts(made.status.describe().c_str());

    bullet_buoyancy::BodyDef def;
    def.hull = made.hull;  // shared by as many bodies as you like
    buoyancy.addBody(boat, def);
    // [end]
    ASSERT_TRUE(made.hull);
    EXPECT_NEAR(made.hull->moments.volume, 4, 1e-12);
    EXPECT_EQ(made.status.describe(), "ok");
    EXPECT_EQ(buoyancy.bodyCount(), 1u);
}

TEST(FloatACrate, IsBallastedByACompound) {
    btBoxShape box(btVector3(0.6f, 0.3f, 0.4f));
    // [snippet]
    btCompoundShape ballasted;  // its origin is the centre of mass: the box sits 0.2 m above it
    ballasted.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0.2f, 0)), &box);
    // [end]
    const bullet_buoyancy::HullResult made = bullet_buoyancy::hullFromShape(ballasted);
    ASSERT_TRUE(made.hull);
    EXPECT_NEAR(made.hull->moments.centroid().y(), 0.2, 1e-7);
}

}  // namespace
