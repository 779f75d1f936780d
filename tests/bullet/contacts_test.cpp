#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/float_scene.h"
#include "support/bullet_cases.h"

namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;
using scenes::heightAboveWater;
using scenes::poseOf;
using scenes::SceneDef;
using scenes::upInBody;

std::unique_ptr<btBoxShape> boxShape(const Vec3& size) {
    return std::make_unique<btBoxShape>(toBullet(size / 2));
}

/// A thin rod of length L and density ratio s, hinged at one end at height H above the water: its wet part
/// carries it where the moments balance, s L^2 = L^2 - d^2 with d the length in the air, so that cos(angle) =
/// H / (L sqrt(1 - s)).
TEST(Hinge, ARodHangsIntoTheWaterAtTheAngleOfBalance) {
    constexpr double length = 2, thickness = 0.02, height = 1;
    for (double ratio : {0.3, 0.5, 0.7}) {
        FloatScene scene;
        const double startAngle = 0.3;  // from the vertical
        Pose pose;
        pose.orientation = Eigen::AngleAxisd(-startAngle, Vec3::UnitY());
        pose.position = Vec3(0, 0, height) + pose.orientation * Vec3(0, 0, -length / 2);
        btRigidBody& rod = scene.addFloatingBox({thickness, thickness, length}, ratio, pose);
        btHingeConstraint hinge(rod, btVector3(0, 0, btScalar(length / 2)), btVector3(0, 1, 0));
        scene.world().addConstraint(&hinge);
        scene.run(60, dt);
        scene.world().removeConstraint(&hinge);

        const double angle = std::acos(upInBody(rod, scene.water()).z());
        // The section's own restoring moment is of order (thickness / length)^2; Bullet's joint gives a
        // little.
        EXPECT_NEAR(angle, std::acos(height / (length * std::sqrt(1 - ratio))), 2e-3) << ratio;
    }
}

/// In the air the hinge alone turns the rod: T = 2 pi sqrt(2 L / 3 g), and (w dt)^2 of it by the step.
TEST(Hinge, APendulumInTheAirSwingsInItsPeriod) {
    constexpr double length = 2, step = 1.0 / 240;
    FloatScene scene;
    Pose pose;
    pose.orientation = Eigen::AngleAxisd(0.05, Vec3::UnitY());
    pose.position = Vec3(0, 0, 10) + pose.orientation * Vec3(0, 0, -length / 2);
    btRigidBody& rod = scene.addFloatingBox({0.02, 0.02, length}, 0.5, pose);
    btHingeConstraint hinge(rod, btVector3(0, 0, btScalar(length / 2)), btVector3(0, 1, 0));
    scene.world().addConstraint(&hinge);
    double before = -1, first = 0, last = 0;
    int periods = -1;
    while (scene.time() < 30) {
        scene.step(step);
        const double x = poseOf(rod).position.x();
        if (before < 0 && x >= 0) {
            last = scene.time() - step * x / (x - before);
            if (++periods == 0) first = last;
        }
        before = x;
    }
    scene.world().removeConstraint(&hinge);
    const double expected = 2 * pi * std::sqrt(2 * length / (3 * standardGravity));
    ASSERT_GT(periods, 5);
    EXPECT_NEAR((last - first) / periods / expected, 1, 2e-3);
}

/// In the plane a body has no gyroscopic terms: with the action, out of the water, it must do just what
/// Bullet alone makes of the blow.
TEST(Quay, AGlancingBlowTurnsACrateAsInBulletAlone) {
    const auto afterTheBlow = [](bool withAction) {
        SceneDef def;
        def.gravity = 0;
        FloatScene scene(def);
        btRigidBody& quay = scene.addStatic(boxShape({1, 10, 10}), at({2, 0, 20}));
        quay.setFriction(0);
        Pose pose = at({0, 0, 20});
        pose.orientation = Eigen::AngleAxisd(0.3, Vec3::UnitZ());
        btRigidBody& crate = scene.addBody(boxShape({1, 0.6, 0.8}), 100, pose);
        crate.setRestitution(btScalar(0.5));
        quay.setRestitution(1);
        crate.setFlags(0);
        crate.setLinearVelocity({2, 0, 0});
        if (withAction) scene.buoyancy().addBody(crate);
        scene.run(2, dt);
        return std::pair(toEigen(crate.getLinearVelocity()), toEigen(crate.getAngularVelocity()));
    };
    const auto [velocity, spin] = afterTheBlow(true);
    const auto [bulletsVelocity, bulletsSpin] = afterTheBlow(false);
    ASSERT_GT(std::abs(bulletsSpin.z()), 0.5);  // the blow did turn it
    // The momentum that the library keeps goes through single precision and back in each step.
    EXPECT_LT((velocity - bulletsVelocity).norm(), 1e-4);
    EXPECT_LT((spin - bulletsSpin).norm(), 1e-4);
}

TEST(Quay, StopsACrateThatTheCurrentPushesAgainstIt) {
    SceneDef def;
    def.flowVelocityWorld = {1, 0, 0};
    FloatScene scene(def);
    scene.addStatic(boxShape({1, 20, 20}), at({5.5, 0, 0}));
    btRigidBody& crate = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    scene.run(30, dt);
    const Pose pose = poseOf(crate);
    EXPECT_NEAR(pose.position.x(), 4, 0.02);  // Bullet lets resting boxes sink in by about a centimetre
    EXPECT_NEAR(double(crate.getLinearVelocity().x()), 1.5 * dt, 1.5 * dt + 1e-3);  // the drag of one step
    EXPECT_GT(upInBody(crate, scene.water()).z(), 0.98);
    EXPECT_LT(crate.getAngularVelocity().length(), 0.05);
}

TEST(Raft, CarriesTwoStackedCratesAtTheDraftOfTheirSum) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({4, 4, 0.5}, 0.3, at({0, 0, 0.1}));
    btRigidBody& lower = scene.addFloatingBox({0.8, 0.8, 0.8}, 0.4, at({0.3, 0.2, 0.76}));
    btRigidBody& upper = scene.addFloatingBox({0.8, 0.8, 0.8}, 0.4, at({0.3, 0.2, 1.57}));
    scene.run(30, dt);
    const double volume = 0.3 * 8 + 2 * 0.4 * 0.512;
    EXPECT_NEAR(scene.buoyancy().report(raft).submergedVolume, volume, 0.01 * volume);
    for (const btRigidBody* body : {&raft, &lower, &upper})
        EXPECT_GT(upInBody(*body, scene.water()).z(), 0.99);
    const double raftHeight = heightAboveWater(raft, scene.water());
    EXPECT_NEAR(heightAboveWater(lower, scene.water()), raftHeight + 0.65, 0.03);
    EXPECT_NEAR(heightAboveWater(upper, scene.water()), raftHeight + 1.45, 0.05);
    EXPECT_NEAR(poseOf(upper).position.x(), 0.3, 0.1);
}

}  // namespace
}  // namespace bullet_buoyancy::test
