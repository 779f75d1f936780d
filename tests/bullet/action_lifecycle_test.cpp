#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/float_scene.h"
#include "support/bullet_cases.h"

namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;
using scenes::heightAboveWater;

constexpr btScalar nan = std::numeric_limits<btScalar>::quiet_NaN();

std::unique_ptr<btCollisionShape> crateShape() {
    return std::make_unique<btBoxShape>(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
}

/// What must be the same of a body that was refused or given back.
struct Borrowed {
    btScalar linearDamping, angularDamping;
    int flags;

    explicit Borrowed(const btRigidBody& body)
        : linearDamping(body.getLinearDamping()),
          angularDamping(body.getAngularDamping()),
          flags(body.getFlags()) {}

    bool operator==(const Borrowed& other) const {
        return linearDamping == other.linearDamping && angularDamping == other.angularDamping &&
               flags == other.flags;
    }
};

TEST(AddBody, RefusesWhatCannotFloatAndSaysWhy) {
    FloatScene scene;
    const auto refused = [&](btRigidBody& body, BodyError why, const char* text, const BodyDef& def = {}) {
        const Borrowed before(body);
        const BodyStatus status = scene.buoyancy().addBody(body, def);
        EXPECT_FALSE(status) << text;
        EXPECT_EQ(status.error, why) << text;
        EXPECT_NE(status.describe().find(text), std::string::npos) << status.describe();
        EXPECT_TRUE(before == Borrowed(body)) << text;
        EXPECT_EQ(scene.buoyancy().report(body).state, BodyState::notAdded);
    };
    refused(scene.addStatic(crateShape(), at({0, 0, 0})), BodyError::staticBody, "static");

    btRigidBody& kinematic = scene.addBody(crateShape(), 300, at({2, 0, 0}));
    kinematic.setCollisionFlags(kinematic.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    refused(kinematic, BodyError::kinematicBody, "kinematic");

    btRigidBody& lost = scene.addBody(crateShape(), 300, at({4, 0, 0}));
    lost.setLinearVelocity({nan, 0, 0});
    refused(lost, BodyError::notFinite, "not finite");
    lost.setLinearVelocity({0, 0, 0});

    btRigidBody& fine = scene.addBody(crateShape(), 300, at({6, 0, 0}));
    BodyDef def;
    def.linearDrag = -1;
    refused(fine, BodyError::badSettings, "drag", def);
    def.linearDrag = 0;
    def.angularDamping = std::numeric_limits<double>::quiet_NaN();
    refused(fine, BodyError::badSettings, "damping", def);

    def.angularDamping = 0;
    def.hull = std::make_shared<Hull>();
    refused(fine, BodyError::badHull, "no volume", def);

    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    fine.setCollisionShape(&plane);
    refused(fine, BodyError::badHull, "plane");
    fine.setCollisionShape(nullptr);
    refused(fine, BodyError::noShape, "no collision shape");
    fine.setCollisionShape(lost.getCollisionShape());
}

TEST(AddBody, TakesABodyOnlyOnce) {
    FloatScene scene;
    btRigidBody& crate = scene.addBody(crateShape(), 300, at({0, 0, 0}));
    EXPECT_TRUE(scene.buoyancy().addBody(crate));
    EXPECT_EQ(scene.buoyancy().addBody(crate).error, BodyError::alreadyAdded);
    EXPECT_EQ(scene.buoyancy().bodyCount(), 1u);
}

TEST(RemoveBody, GivesDampingAndGyroscopicFlagsBack) {
    FloatScene scene;
    btRigidBody& crate = scene.addBody(crateShape(), 300, at({0, 0, 0}));
    crate.setDamping(btScalar(0.1), btScalar(0.3));
    crate.setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD | BT_DISABLE_WORLD_GRAVITY);
    const Borrowed before(crate);

    scene.buoyancy().addBody(crate);
    EXPECT_EQ(crate.getAngularDamping(), 0);
    EXPECT_EQ(crate.getLinearDamping(), 0);
    EXPECT_EQ(crate.getFlags(), BT_DISABLE_WORLD_GRAVITY);
    scene.run(0.5, dt);
    EXPECT_TRUE(scene.buoyancy().removeBody(crate));
    EXPECT_TRUE(before == Borrowed(crate));
    EXPECT_FALSE(scene.buoyancy().removeBody(crate));
}

TEST(RemoveBody, GivesBackWhatTheUserSetInTheMeantime) {
    FloatScene scene;
    btRigidBody& crate = scene.addFloatingBox({1, 1, 1}, 1, at({0, 0, -10}));
    scene.run(0.5, dt);
    crate.setDamping(btScalar(0.1), btScalar(0.3));
    scene.run(0.5, dt);
    EXPECT_EQ(crate.getAngularDamping(), 0);  // while it belongs to the action
    scene.buoyancy().removeBody(crate);
    EXPECT_EQ(crate.getLinearDamping(), btScalar(0.1));
    EXPECT_EQ(crate.getAngularDamping(), btScalar(0.3));
}

/// What sleeps does not notice by itself that the water has come or gone.
TEST(ASleepingBody, IsWokenWhenItIsAddedRemovedOrReweighed) {
    FloatScene scene;
    btRigidBody& raft =
        scene.addBody(std::make_unique<btBoxShape>(btVector3(1, 1, btScalar(0.5))), 2000, at({0, 0, -3}));
    raft.forceActivationState(ISLAND_SLEEPING);
    scene.buoyancy().addBody(raft);
    scene.run(60, dt);
    ASSERT_FALSE(raft.isActive());
    EXPECT_NEAR(scene.buoyancy().report(raft).submergedVolume, 2, 2e-3);

    btVector3 inertia;
    raft.getCollisionShape()->calculateLocalInertia(3000, inertia);
    raft.setMassProps(3000, inertia);
    raft.updateInertiaTensor();
    scene.run(60, dt);
    ASSERT_FALSE(raft.isActive());
    EXPECT_NEAR(scene.buoyancy().report(raft).submergedVolume, 3, 2e-3);

    scene.buoyancy().removeBody(raft);
    scene.run(1, dt);
    EXPECT_LT(heightAboveWater(raft, scene.water()), -1);
}

TEST(RemoveBody, LeavesTheOthersFloating) {
    FloatScene scene;
    std::vector<btRigidBody*> crates;
    for (int i = 0; i < 4; ++i)
        crates.push_back(&scene.addFloatingBox({3, 3, 1}, 0.5, at({5.0 * i, 0, 0.5})));
    EXPECT_TRUE(scene.buoyancy().removeBody(*crates[1]));
    scene.run(30, dt);
    for (std::size_t i : {0u, 2u, 3u})
        EXPECT_NEAR(scene.buoyancy().report(*crates[i]).wetFraction, 0.5, 1e-4) << i;
    EXPECT_EQ(scene.buoyancy().report(*crates[1]).state, BodyState::notAdded);
    EXPECT_LT(heightAboveWater(*crates[1], scene.water()), -100);  // it sank
    scene.buoyancy().removeAllBodies();
    EXPECT_EQ(scene.buoyancy().bodyCount(), 0u);
}

/// The address sanitizer watches over this one.
TEST(RemoveBody, ABodyDeletedAfterwardsIsNeverTouched) {
    FloatScene scene;
    btRigidBody& other = scene.addFloatingBox({3, 3, 1}, 0.5, at({5, 0, 0.5}));
    const auto shape = crateShape();
    auto crate = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(300, nullptr, shape.get(), btVector3(50, 50, 50)));
    scene.world().addRigidBody(crate.get());
    ASSERT_TRUE(scene.buoyancy().addBody(*crate));
    scene.run(0.5, dt);
    scene.buoyancy().removeBody(*crate);
    scene.world().removeRigidBody(crate.get());
    crate.reset();
    scene.run(0.5, dt);
    EXPECT_EQ(scene.buoyancy().report(other).state, BodyState::floating);
}

TEST(ABodyOutOfTheWorld, IsNotTouchedAndFloatsAgainWhenItIsBack) {
    FloatScene scene;
    btRigidBody& crate = scene.addFloatingBox({3, 3, 1}, 0.5, at({0, 0, -0.3}));
    scene.run(0.2, dt);
    scene.world().removeRigidBody(&crate);
    const btVector3 velocity = crate.getLinearVelocity();
    scene.run(0.5, dt);
    EXPECT_EQ(crate.getLinearVelocity(), velocity);
    EXPECT_EQ(scene.buoyancy().report(crate).state, BodyState::notInWorld);
    scene.world().addRigidBody(&crate);
    scene.run(30, dt);
    EXPECT_NEAR(scene.buoyancy().report(crate).wetFraction, 0.5, 1e-4);
}

TEST(ABodyMadeKinematic, IsLeftAloneAndFloatsAgainAfterwards) {
    FloatScene scene;
    btRigidBody& crate = scene.addFloatingBox({3, 3, 1}, 0.5, at({0, 0, 0.2}));
    scene.run(0.2, dt);
    const int flags = crate.getCollisionFlags();
    crate.setCollisionFlags(flags | btCollisionObject::CF_KINEMATIC_OBJECT);
    const btVector3 position = crate.getWorldTransform().getOrigin();
    scene.run(0.5, dt);
    EXPECT_EQ(scene.buoyancy().report(crate).state, BodyState::notDynamic);
    EXPECT_EQ(crate.getWorldTransform().getOrigin(), position);
    crate.setCollisionFlags(flags);
    scene.run(30, dt);
    EXPECT_NEAR(scene.buoyancy().report(crate).wetFraction, 0.5, 1e-4);
}

TEST(ABodyThatTurnsNotFinite, IsReportedAndLeavesTheOthersFloating) {
    FloatScene scene;
    btRigidBody& lost = scene.addFloatingBox({3, 3, 1}, 0.5, at({0, 0, 0.2}));
    btRigidBody& other = scene.addFloatingBox({3, 3, 1}, 0.5, at({9, 0, 0.2}));
    scene.run(0.2, dt);
    // Out of Bullet's sight, whose own broadphase cannot hold it.
    lost.setAngularVelocity({nan, 0, 0});
    scene.buoyancy().updateAction(&scene.world(), btScalar(dt));
    EXPECT_EQ(scene.buoyancy().report(lost).state, BodyState::notFinite);
    EXPECT_EQ(scene.buoyancy().report(other).state, BodyState::floating);
    lost.setAngularVelocity({0, 0, 0});
    scene.run(30, dt);
    EXPECT_NEAR(scene.buoyancy().report(lost).wetFraction, 0.5, 1e-4);
}

TEST(ABodyWhoseMassChanges, FloatsAtItsNewDraft) {
    FloatScene scene;
    btRigidBody& barge = scene.addFloatingBox({3, 3, 1}, 0.3, at({0, 0, 0.2}));
    scene.run(10, dt);
    btVector3 inertia;
    barge.getCollisionShape()->calculateLocalInertia(6300, inertia);
    barge.setMassProps(6300, inertia);
    barge.updateInertiaTensor();
    scene.run(30, dt);
    EXPECT_NEAR(scene.buoyancy().report(barge).submergedVolume, 6.3, 1e-3);
}

TEST(ABodyWhoseInertiaChanges, KeepsItsSpin) {
    FloatScene scene;
    BodyDef def;
    def.linearDrag = def.angularDamping = 0;
    btRigidBody& top = scene.addFloatingBox({1, 1, 1}, 1, at({0, 0, -10}), def);
    top.setAngularVelocity({0, 0, 3});
    scene.run(1, dt);
    top.setMassProps(1000, btVector3(500, 500, 500));
    top.updateInertiaTensor();
    scene.run(1, dt);
    EXPECT_NEAR(double(top.getAngularVelocity().z()), 3, 1e-5);
}

/// Forgotten calculateLocalInertia: it floats, but cannot turn.
TEST(ABodyWithoutInertia, FloatsUpright) {
    FloatScene scene;
    Pose pose = at({0, 0, 0.3});
    pose.orientation = Eigen::AngleAxisd(0.3, Vec3::UnitX());
    btRigidBody& crate = scene.addBody(crateShape(), 500, Vec3::Zero(), pose);
    const BodyStatus status = scene.buoyancy().addBody(crate);
    EXPECT_TRUE(status);
    EXPECT_FALSE(status.canTurn);
    EXPECT_NE(status.describe().find("inertia"), std::string::npos);
    scene.run(30, dt);
    EXPECT_NEAR(scene.buoyancy().report(crate).wetFraction, 0.5, 1e-4);
    EXPECT_FALSE(scene.buoyancy().report(crate).modelled.angularMomentum);
    EXPECT_LT(scenes::poseOf(crate).orientation.angularDistance(pose.orientation), 1e-5);
}

TEST(ABodyWhoseInertiaIsTakenAndGivenBack, TurnsAgain) {
    FloatScene scene;
    Pose pose = at({0, 0, 0});
    pose.orientation = Eigen::AngleAxisd(0.3, Vec3::UnitX());
    btRigidBody& raft = scene.addFloatingBox({3, 3, 1}, 0.5, pose);
    const btVector3 inertia = raft.getLocalInertia();
    raft.setMassProps(4500, btVector3(0, 0, 0));
    raft.updateInertiaTensor();
    scene.run(10, dt);
    EXPECT_LT(scenes::poseOf(raft).orientation.angularDistance(pose.orientation), 1e-5);
    raft.setMassProps(4500, inertia);
    raft.updateInertiaTensor();
    scene.run(60, dt);
    EXPECT_GT(scenes::upInBody(raft, scene.water()).z(), 1 - 1e-6);
}

TEST(AnAbsurdTimeStep, IsReportedAndDoesNothing) {
    FloatScene scene;
    btRigidBody& crate = scene.addFloatingBox({1, 1, 1}, 0.5, at({0, 0, 0}));
    for (btScalar step : {btScalar(0), btScalar(-1), nan, std::numeric_limits<btScalar>::infinity()}) {
        scene.buoyancy().updateAction(&scene.world(), step);
        EXPECT_EQ(crate.getLinearVelocity().length(), 0);
        EXPECT_EQ(scene.buoyancy().report(crate).state, BodyState::badStep);
    }
}

/// Compound parts that overlap are taken, and said to displace twice.
TEST(AddBody, PassesTheHullsRemarksOn) {
    FloatScene scene;
    auto compound = std::make_unique<btCompoundShape>();
    const auto part = crateShape();
    compound->addChildShape(btTransform::getIdentity(), part.get());
    compound->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(btScalar(0.5), 0, 0)),
                            part.get());
    btRigidBody& body = scene.addBody(std::move(compound), 300, at({0, 0, 0}));
    const BodyStatus status = scene.buoyancy().addBody(body);
    EXPECT_TRUE(status);
    EXPECT_EQ(status.hull.overlappingPairs, 1u);
    EXPECT_NEAR(status.hull.overlapVolume, 0.5, 1e-6);  // aligned boxes: the columns are exact
    EXPECT_NE(status.describe().find("overlap"), std::string::npos);
}

}  // namespace
}  // namespace bullet_buoyancy::test
