// The snippets of the guide "When it doesn't float", and what its table says.

#include <bullet_buoyancy/bullet_buoyancy.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>

#include "docs/pool.h"
#include "support/known_solids.h"

using namespace bullet_buoyancy;

namespace {

/// A crate of 1 m at the origin that floats upright with 0.15 m above the water, if nothing is spoilt.
class Trouble : public testing::Test {
protected:
    test::Pool pool;
    FlatWater sea{WaterFrame::yUp()};
    BuoyancyAction buoyancy{sea};
    btRigidBody* crate = &pool.addBox({1, 1, 1}, 850, {0, 0, 0});

    void SetUp() override { pool.world.addAction(&buoyancy); }
    void TearDown() override { pool.world.removeAction(&buoyancy); }
    BodyReport afterASecond() {
        pool.run(1);
        return buoyancy.report(*crate);
    }
};

// [snippet]
/// What to look at first.
void explain(const BuoyancyAction& buoyancy, const btRigidBody& body, const BodyStatus& ofAddBody) {
    const BodyReport report = buoyancy.report(body);
    std::printf("added: %s\n", ofAddBody.describe().c_str());
    std::printf("state %d; the water acts: %d; shape changed: %d; spin limited: %d\n", int(report.state),
                report.modelled.hydrostatics, report.shapeHasChanged, report.spinIsLimited);
    std::printf("%.4g m^3 under water, %.3g of the hull; weight %.4g N, lift %.4g N\n",
                report.submergedVolume, report.wetFraction,
                double((body.getGravity() / body.getInvMass()).length()), double(report.forceWorld.length()));
}
// [end]

TEST_F(Trouble, IsNoneByItself) {
    const BodyStatus status = buoyancy.addBody(*crate);
    const BodyReport report = afterASecond();
    testing::internal::CaptureStdout();
    explain(buoyancy, *crate, status);
    EXPECT_EQ(testing::internal::GetCapturedStdout().substr(0, 10), "added: ok\n");
    EXPECT_TRUE(report.modelled.hydrostatics);
    EXPECT_EQ(report.state, BodyState::floating);
    EXPECT_FALSE(report.shapeHasChanged || report.spinIsLimited);
}

TEST_F(Trouble, NotAddedToTheAction) {
    EXPECT_EQ(afterASecond().state, BodyState::notAdded);
}

TEST_F(Trouble, ActionNotAddedToTheWorld) {
    pool.world.removeAction(&buoyancy);
    buoyancy.addBody(*crate);
    EXPECT_EQ(afterASecond().state, BodyState::notStepped);
}

TEST_F(Trouble, BodyNotInTheWorld) {
    buoyancy.addBody(*crate);
    pool.world.removeRigidBody(crate);
    EXPECT_EQ(afterASecond().state, BodyState::notInWorld);
    pool.world.addRigidBody(crate);
}

TEST_F(Trouble, Refused) {
    EXPECT_EQ(buoyancy.addBody(pool.addBox({1, 1, 1}, 0, {5, 0, 0})).error, BodyError::staticBody);
    crate->setCollisionFlags(crate->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    EXPECT_EQ(buoyancy.addBody(*crate).error, BodyError::kinematicBody);
    crate->setCollisionFlags(crate->getCollisionFlags() & ~btCollisionObject::CF_KINEMATIC_OBJECT);
    EXPECT_TRUE(buoyancy.addBody(*crate));
    EXPECT_EQ(buoyancy.addBody(*crate).error, BodyError::alreadyAdded);

    btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
    btRigidBody ground(1, nullptr, &plane, btVector3(1, 1, 1));
    EXPECT_EQ(buoyancy.addBody(ground).error, BodyError::badHull);
}

/// Gravity along y and water whose up is z: no gravity, and so no pressure, along the water's down.
TEST_F(Trouble, UpIsAnotherAxis) {
    const FlatWater sideways(WaterFrame::zUp());
    BuoyancyAction wrong(sideways);
    pool.world.addAction(&wrong);
    wrong.addBody(*crate);
    pool.run(1);
    const BodyReport report = wrong.report(*crate);
    pool.world.removeAction(&wrong);
    EXPECT_GT(report.wetFraction, 0);
    EXPECT_FALSE(report.modelled.hydrostatics);
    EXPECT_EQ(report.forceWorld.length(), 0);
    EXPECT_LT(crate->getWorldTransform().getOrigin().y(), -1) << "it falls, if against drag";
}

TEST_F(Trouble, TooHeavyOrFarTooLight) {
    btRigidBody& stone = pool.addBox({1, 1, 1}, 2500, {5, 0, 0});
    btRigidBody& balloon = pool.addBox({1, 1, 1}, 1, {-5, 0.5, 0});
    buoyancy.addBody(stone);
    buoyancy.addBody(balloon);
    pool.run(10);
    EXPECT_EQ(buoyancy.report(stone).state, BodyState::submerged);
    EXPECT_LT(stone.getWorldTransform().getOrigin().y(), -5);
    EXPECT_NEAR(buoyancy.report(balloon).wetFraction, 0.001, 1e-5);
}

/// A box without one of its sides: the water pushes on the other.
TEST_F(Trouble, OpenMesh) {
    TriangleMesh mesh = test::boxMesh({1, 1, 1});
    const auto isSide = [&](const Triangle& t) {
        return mesh.vertices[t[0]].x() > 0.4 && mesh.vertices[t[1]].x() > 0.4 &&
               mesh.vertices[t[2]].x() > 0.4;
    };
    mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), isSide),
                         mesh.triangles.end());
    ASSERT_EQ(mesh.triangles.size(), 10u);
    // [snippet]
    const HullResult made = makeHull(mesh);
    if (!made.hull || made.status.openEdges > 0) std::puts(made.status.describe().c_str());
    // [end]
    ASSERT_TRUE(made.hull);
    EXPECT_EQ(made.status.openEdges, 4u);
    BodyDef def;
    def.hull = made.hull;
    buoyancy.addBody(*crate, def);
    pool.run(0.1);
    EXPECT_GT(double(buoyancy.report(*crate).forceWorld.x()), 100);
    EXPECT_GT(double(buoyancy.report(*crate).velocity.x()), 0);
}

TEST_F(Trouble, PartsOverlap) {
    btBoxShape box(btVector3(0.5f, 0.5f, 0.5f));
    btCompoundShape two;
    two.addChildShape(btTransform::getIdentity(), &box);
    two.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0.5f, 0, 0)), &box);
    const HullStatus status = hullFromShape(two).status;
    EXPECT_EQ(status.overlappingPairs, 1u);
    EXPECT_NEAR(status.overlapVolume, 0.5, 0.02);
}

TEST_F(Trouble, NoGravityInTheWorld) {
    pool.world.setGravity(btVector3(0, 0, 0));
    buoyancy.addBody(*crate);
    EXPECT_FALSE(afterASecond().modelled.hydrostatics);
}

TEST_F(Trouble, FramesLongerThanTheirSubsteps) {
    pool.world.stepSimulation(1, 1);
    EXPECT_NEAR(buoyancy.time(), 1. / 60, 1e-6);
}

TEST_F(Trouble, MeshTurnedInwardIsMended) {
    TriangleMesh mesh = test::boxMesh({1, 1, 1});
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    const HullResult made = makeHull(mesh);
    ASSERT_TRUE(made.hull);
    EXPECT_EQ(made.status.flippedTriangles, 12u);
    EXPECT_NEAR(made.hull->moments.volume, 1, 1e-12);
}

/// Bullet takes what it is given: an inertia of zero is one that nothing turns.
TEST_F(Trouble, InertiaForgotten) {
    crate->setMassProps(850, btVector3(0, 0, 0));
    crate->setWorldTransform(btTransform(btQuaternion(btVector3(0, 0, 1), btScalar(0.3))));
    const BodyStatus status = buoyancy.addBody(*crate);
    EXPECT_TRUE(status.ok());
    EXPECT_FALSE(status.canTurn);
    const BodyReport report = afterASecond();
    EXPECT_FALSE(report.modelled.angularMomentum);
    EXPECT_EQ(report.spin.length(), 0);
    EXPECT_GT(report.torqueAboutCom.length(), 1);
}

TEST_F(Trouble, AsleepWhereItWasPut) {
    buoyancy.addBody(*crate);
    pool.run(60);
    ASSERT_EQ(buoyancy.report(*crate).state, BodyState::asleep) << "at rest in still water";
    btTransform above = crate->getWorldTransform();
    above.getOrigin().setY(3);
    crate->setWorldTransform(above);
    EXPECT_EQ(afterASecond().state, BodyState::asleep);
    crate->activate();
    EXPECT_NE(afterASecond().state, BodyState::asleep);
}

TEST_F(Trouble, ShapeScaledLater) {
    buoyancy.addBody(*crate);
    pool.run(1);
    crate->getCollisionShape()->setLocalScaling(btVector3(2, 1, 2));
    EXPECT_TRUE(afterASecond().shapeHasChanged);
    // [snippet]
    const BodyStatus status = buoyancy.updateHull(*crate);  // reads the shape that it has now
    // [end]
    EXPECT_TRUE(status);
    EXPECT_FALSE(afterASecond().shapeHasChanged);
    pool.run(20);
    EXPECT_NEAR(buoyancy.report(*crate).wetFraction, 0.85 / 4, 1e-3);
}

/// Bullet gives a convex hull a margin of 0.04 m, with which it rests on others; water wets what is drawn.
TEST_F(Trouble, MarginsAreNotWetted) {
    btConvexHullShape shape;
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            for (double z : {-0.5, 0.5})
                shape.addPoint(btVector3(btScalar(x), btScalar(y), btScalar(z)));
    const HullResult made = hullFromShape(shape);
    ASSERT_TRUE(made.hull);
    EXPECT_GT(shape.getMargin(), 0.01);
    EXPECT_NEAR(made.hull->moments.volume, 1, 1e-6);
}

TEST_F(Trouble, StepOfNoLength) {
    buoyancy.addBody(*crate);
    pool.run(1);
    buoyancy.updateAction(&pool.world, 0);
    EXPECT_EQ(buoyancy.report(*crate).state, BodyState::badStep);
}

TEST_F(Trouble, SpinPastBulletsLimit) {
    buoyancy.addBody(*crate);
    pool.run(1);
    crate->setAngularVelocity(btVector3(0, 60, 0));  // 1 rad a step
    pool.run(0.1);
    EXPECT_TRUE(buoyancy.report(*crate).spinIsLimited);
}

/// Ground at the level of the water, as in many first scenes.
TEST_F(Trouble, LiesOnTheGround) {
    pool.addBox({20, 1, 20}, 0, {0, -0.5, 0});
    btTransform above = crate->getWorldTransform();
    above.getOrigin().setY(0.6f);
    crate->setWorldTransform(above);
    buoyancy.addBody(*crate);
    const BodyReport report = afterASecond();
    EXPECT_LT(report.submergedVolume, 0.05) << "its weight is 0.85 m^3 of water";
    EXPECT_LT(double(report.forceWorld.length()), 0.5 * 850 * 9.81);
    EXPECT_NEAR(double(crate->getWorldTransform().getOrigin().y()), 0.5, 0.05);
}

TEST_F(Trouble, MadeStaticOrNotANumberLater) {
    buoyancy.addBody(*crate);
    pool.run(1);
    crate->setLinearVelocity(btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0));
    buoyancy.updateAction(&pool.world, btScalar(1) / 60);
    EXPECT_EQ(buoyancy.report(*crate).state, BodyState::notFinite);
    crate->setLinearVelocity(btVector3(0, 0, 0));
    crate->setMassProps(0, btVector3(0, 0, 0));
    buoyancy.updateAction(&pool.world, btScalar(1) / 60);
    EXPECT_EQ(buoyancy.report(*crate).state, BodyState::notDynamic);
}

TEST_F(Trouble, WavesThatWereRefused) {
    GerstnerWavesDef def;
    def.components = {{1, 2, 0, frequencyOfWavenumber(2), 0}};  // crests of steepness 2 would loop
    // [snippet]
    const GerstnerWaves waves(WaterFrame::yUp(), def);
    if (!waves.status()) std::puts(waves.status().describe().c_str());
    // [end]
    EXPECT_EQ(waves.status().error, WaterError::loopedCrest);
    EXPECT_TRUE(waves.bounds().isFlat());
}

/// Between steps Bullet's velocity has g dt upward.
TEST_F(Trouble, BulletsVelocityAtRest) {
    buoyancy.addBody(*crate);
    pool.run(20);
    crate->activate();
    pool.run(0.1);
    EXPECT_NEAR(double(crate->getLinearVelocity().y()), 9.81 / 60, 1e-3);
    EXPECT_LT(double(buoyancy.report(*crate).velocity.length()), 1e-3);
}

}  // namespace
