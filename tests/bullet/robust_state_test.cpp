#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/float_scene.h"
#include "support/bullet_cases.h"

/// Whatever befalls one body, the others float on.
namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;
using scenes::poseOf;

constexpr btScalar nan = std::numeric_limits<btScalar>::quiet_NaN();
constexpr btScalar infinite = std::numeric_limits<btScalar>::infinity();

/// A body in trouble, and one beside it.
struct Pair {
    FloatScene scene;
    btRigidBody& body = scene.addFloatingBox({3, 3, 1}, 0.5, at({0, 0, 0.2}));
    btRigidBody& other = scene.addFloatingBox({3, 3, 1}, 0.5, at({9, 0, 0.2}));

    BodyState state() { return scene.buoyancy().report(body).state; }

    /// Out of Bullet's sight, whose own broadphase cannot hold what is not finite.
    void act() { scene.buoyancy().updateAction(&scene.world(), btScalar(dt)); }

    void expectBothFloat() {
        scene.run(60, dt);
        for (const btRigidBody* floating : {&body, &other})
            EXPECT_NEAR(scene.buoyancy().report(*floating).wetFraction, 0.5, 1e-4);
    }
};

struct Harm {
    const char* name;
    std::function<void(btRigidBody&)> spoil, mend;
};

std::vector<Harm> harms() {
    const auto setX = [](btScalar x) {
        return [x](btRigidBody& body) { body.getWorldTransform().getOrigin().setX(x); };
    };
    const auto setMass = [](btScalar inertia) {
        return [inertia](btRigidBody& body) {
            body.setMassProps(4500, btVector3(3750, 3750, inertia));
            body.updateInertiaTensor();
        };
    };
    return {{"position", setX(nan), setX(0)},
            {"infinite position", setX(infinite), setX(0)},
            {"orientation", [](btRigidBody& b) { b.getWorldTransform().getBasis()[1].setY(nan); },
             [](btRigidBody& b) { b.getWorldTransform().setBasis(btMatrix3x3::getIdentity()); }},
            {"velocity",
             [](btRigidBody& b) {
                 b.setLinearVelocity({0, infinite, 0});
             },
             [](btRigidBody& b) {
                 b.setLinearVelocity({0, 0, 0});
             }},
            {"spin",
             [](btRigidBody& b) {
                 b.setAngularVelocity({nan, 0, 0});
             },
             [](btRigidBody& b) {
                 b.setAngularVelocity({0, 0, 0});
             }},
            {"inertia", setMass(nan), setMass(6750)}};
}

TEST(ABodyThatTurnsNotFinite, IsReportedAndFloatsAgainOnceMended) {
    for (const Harm& harm : harms()) {
        SCOPED_TRACE(harm.name);
        Pair pair;
        pair.scene.run(0.2, dt);
        harm.spoil(pair.body);
        pair.act();
        EXPECT_EQ(pair.state(), BodyState::notFinite);
        EXPECT_EQ(pair.scene.buoyancy().report(pair.other).state, BodyState::floating);
        EXPECT_TRUE(toEigen(pair.other.getLinearVelocity()).allFinite());
        harm.mend(pair.body);
        pair.expectBothFloat();
    }
}

TEST(ABodyOfZeroMass, IsReportedAndFloatsAgainWhenItWeighs) {
    Pair pair;
    pair.scene.run(0.2, dt);
    const btVector3 inertia = pair.body.getLocalInertia();
    pair.body.setMassProps(0, {0, 0, 0});
    pair.scene.run(0.5, dt);
    EXPECT_EQ(pair.state(), BodyState::notDynamic);
    EXPECT_EQ(pair.scene.buoyancy().report(pair.other).state, BodyState::floating);
    pair.body.setMassProps(4500, inertia);
    pair.body.updateInertiaTensor();
    pair.body.setGravity(pair.scene.world().getGravity());
    pair.expectBothFloat();
}

TEST(ABodyPutToSleepAndWoken, FloatsOn) {
    Pair pair;
    pair.scene.run(0.2, dt);
    pair.body.forceActivationState(ISLAND_SLEEPING);
    pair.scene.run(0.5, dt);
    EXPECT_EQ(pair.state(), BodyState::asleep);
    pair.body.forceActivationState(DISABLE_DEACTIVATION);
    pair.expectBothFloat();
}

/// High up, deep down, upside down.
TEST(ABodyTeleported, FloatsWhereItIsPut) {
    for (double height : {30.0, -30.0}) {
        Pair pair;
        pair.scene.run(0.2, dt);
        const Pose pose{Vec3(0, 0, height), Eigen::Quaterniond(Eigen::AngleAxisd(3, Vec3::UnitX()))};
        pair.body.setWorldTransform(toTransform(pose));
        pair.body.updateInertiaTensor();
        pair.scene.step(dt);
        EXPECT_NEAR(poseOf(pair.body).position.z(), height, 0.05);
        EXPECT_LT(poseOf(pair.body).orientation.angularDistance(pose.orientation), 0.05);
        // The energy that the hand gave is others' doing.
        const BodyReport report = pair.scene.buoyancy().report(pair.body);
        EXPECT_NEAR(report.energy.expected(), report.totalEnergy(), 0.01 * std::abs(report.totalEnergy()));
        pair.expectBothFloat();
    }
}

TEST(ABodyWhoseShapeIsScaled, SaysThatItsHullIsStale) {
    Pair pair;
    pair.scene.run(0.2, dt);
    EXPECT_FALSE(pair.scene.buoyancy().report(pair.body).shapeHasChanged);
    pair.body.getCollisionShape()->setLocalScaling({1, 1, 2});
    pair.scene.step(dt);
    EXPECT_TRUE(pair.scene.buoyancy().report(pair.body).shapeHasChanged);
    EXPECT_FALSE(pair.scene.buoyancy().report(pair.other).shapeHasChanged);
    pair.scene.buoyancy().removeBody(pair.body);
    ASSERT_TRUE(pair.scene.buoyancy().addBody(pair.body));
    pair.scene.run(60, dt);
    EXPECT_NEAR(pair.scene.buoyancy().report(pair.body).wetFraction, 0.25, 1e-4);
    EXPECT_NEAR(pair.scene.buoyancy().report(pair.other).wetFraction, 0.5, 1e-4);
}

TEST(ASpinThatBulletCannotFollow, IsReported) {
    FloatScene scene;
    btRigidBody& top = scene.addFloatingBox({1, 1, 1}, 0.5, at({0, 0, 100}));
    top.setAngularVelocity({0, 0, btScalar(pi / 4 * 60 * 0.9)});
    scene.run(0.2, dt);
    EXPECT_FALSE(scene.buoyancy().report(top).spinIsLimited);
    top.setAngularVelocity({0, 0, btScalar(pi / 4 * 60 * 1.5)});
    scene.run(0.2, dt);
    EXPECT_TRUE(scene.buoyancy().report(top).spinIsLimited);
}

}  // namespace
}  // namespace bullet_buoyancy::test
