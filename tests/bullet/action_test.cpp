#include "bullet_buoyancy/bullet/buoyancy_action.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "scenes/float_scene.h"
#include "support/bullet_cases.h"
#include "support/known_solids.h"

namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;
using scenes::heightAboveWater;
using scenes::poseOf;
using scenes::SceneDef;

BodyDef frictionless() {
    BodyDef def;
    def.linearDrag = def.angularDamping = 0;
    return def;
}

TEST(BuoyancyAction, ReportsWhatTheEvaluatorSaysAtTheNewPose) {
    FloatScene scene;
    Pose pose = at({3, -2, 0.1});
    pose.orientation = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized());
    btRigidBody& box = scene.addFloatingBox({1, 0.8, 0.6}, 0.5, pose);
    scene.run(0.5, dt);
    const BodyReport report = scene.buoyancy().report(box);

    const Pose now = poseOf(box);
    const auto hull = hullOf(boxMesh({1, 0.8, 0.6}));
    const HydrostaticResult expected = evaluateExact(*hull, now, scene.water());
    const double weight = 480 * standardGravity;
    EXPECT_EQ(report.state, BodyState::floating);
    EXPECT_TRUE(report.modelled.hydrostatics && report.modelled.linearDrag &&
                report.modelled.angularDamping && report.modelled.angularMomentum);
    EXPECT_LT((toEigen(report.forceWorld) - expected.forceWorld).norm(), poseRounding * weight);
    EXPECT_LT((toEigen(report.torqueAboutCom) - expected.torqueAboutCom).norm(), poseRounding * weight);
    EXPECT_NEAR(report.submergedVolume, expected.submergedVolume, poseRounding);
    EXPECT_NEAR(report.wetFraction, expected.submergedVolume / 0.48, poseRounding);
    EXPECT_LT(
        (toEigen(report.centreOfBuoyancyWorld) - now.position - expected.centreOfBuoyancyFromCom).norm(),
        10 * poseRounding);
    EXPECT_NEAR(report.waterPotentialEnergy, expected.potentialEnergy, poseRounding * weight);
    EXPECT_NEAR(report.gravitationalEnergy, 240 * standardGravity * now.position.z(), poseRounding * weight);
}

TEST(BuoyancyAction, SumsInTheSettingsPrecision) {
    FloatScene scene;
    BuoyancySettings settings;
    settings.precision = Precision::single;
    BuoyancyAction inSingle(scene.water(), settings);
    scene.world().addAction(&inSingle);
    btRigidBody& box =
        scene.addBody(std::make_unique<btBoxShape>(toBullet(Vec3(0.5, 0.4, 0.3))), 240, at({0, 0, 0.1}));
    ASSERT_TRUE(inSingle.addBody(box));
    scene.run(10, dt);
    const BodyReport report = inSingle.report(box);
    scene.world().removeAction(&inSingle);
    EXPECT_GT(report.forceErrorBound, 0);
    EXPECT_LT(report.forceErrorBound, 1e-5 * 480 * standardGravity);
    // At rest where it displaces its weight; swings of 10 s ago have faded to a thousandth.
    EXPECT_NEAR(report.submergedVolume, 0.24, 1e-3 * 0.48);
}

/// One stepSimulation of many substeps, and many of one: dt is a binary fraction, so that Bullet's clock is
/// exact.
TEST(BuoyancyAction, SubstepsInOneCallDoWhatTheyDoInMany) {
    constexpr double binaryStep = 1.0 / 64;
    FloatScene one, many;
    Pose pose = at({0, 0, 0.7});
    pose.orientation = Eigen::AngleAxisd(0.3, Vec3(1, 1, 0).normalized());
    btRigidBody& a = one.addFloatingBox({1, 1, 1}, 0.5, pose);
    btRigidBody& b = many.addFloatingBox({1, 1, 1}, 0.5, pose);
    for (int i = 0; i < 100; ++i) {
        one.step(8 * binaryStep, 8);
        many.run(8 * binaryStep, binaryStep);
    }
    EXPECT_EQ(a.getWorldTransform(), b.getWorldTransform());
    EXPECT_EQ(a.getLinearVelocity(), b.getLinearVelocity());
    EXPECT_EQ(a.getAngularVelocity(), b.getAngularVelocity());
}

/// At the usual 1/60 s Bullet's clock rounds, but no substep is lost or taken twice.
TEST(BuoyancyAction, SubstepsAtSixtyHertzDoWhatTheyDoInMany) {
    FloatScene one, many;
    btRigidBody& a = one.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0.2}), frictionless());
    btRigidBody& b = many.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0.2}), frictionless());
    for (int i = 0; i < 150; ++i) {
        one.step(4 * dt, 4);
        many.run(4 * dt, dt);
        ASSERT_NEAR(heightAboveWater(a, one.water()), heightAboveWater(b, many.water()), 600 * poseRounding)
            << i;
    }
}

TEST(BuoyancyAction, AnyUpAndAnyOriginGiveTheSameMotion) {
    const auto finalHeight = [](const WaterFrame& frame) {
        SceneDef def;
        def.frame = frame;
        FloatScene scene(def);
        // The same pose relative to the water, whatever its frame.
        const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.3, Vec3(1, 2, 0).normalized()));
        Pose pose{frame.originWorld() + 0.4 * frame.upWorld(),
                  Eigen::Quaterniond(frame.worldFromFrame()) * tilt};
        btRigidBody& box = scene.addFloatingBox({1.5, 1, 0.7}, 0.4, pose);
        scene.run(3, dt);
        return heightAboveWater(box, scene.water());
    };
    const double expected = finalHeight(WaterFrame::zUp());
    const double tolerance = 2000 * poseRounding;  // 180 steps of a motion that has not settled
    EXPECT_NEAR(finalHeight(WaterFrame::yUp()), expected, tolerance);
    EXPECT_NEAR(finalHeight(WaterFrame::zUp({5, -3, 2})), expected, tolerance);
    EXPECT_NEAR(finalHeight(WaterFrame::fromUp({1, 2, 3}, {1, -2, 0.5})), expected, tolerance);
}

TEST(BuoyancyAction, WithoutGravityWaterDoesNotPress) {
    SceneDef def;
    def.gravity = 0;
    FloatScene scene(def);
    btRigidBody& box = scene.addFloatingBox({1, 1, 1}, 0.5, at({0, 0, -0.2}));
    scene.run(1, dt);
    EXPECT_EQ(scene.buoyancy().report(box).forceWorld.length(), 0);
    EXPECT_EQ(box.getLinearVelocity().length(), 0);
}

TEST(BuoyancyAction, FloatsManyBodiesEachByItself) {
    FloatScene scene;
    std::vector<btRigidBody*> boxes;
    for (int i = 1; i <= 9; ++i)
        boxes.push_back(&scene.addFloatingBox({3, 3, 1}, i / 10.0, at({5.0 * i, 0, 0.5})));
    scene.run(60, dt);
    for (int i = 1; i <= 9; ++i)
        EXPECT_NEAR(scene.buoyancy().report(*boxes[std::size_t(i - 1)]).wetFraction, i / 10.0, 1e-4) << i;
}

TEST(BuoyancyAction, DenserWaterCarriesHigher) {
    SceneDef def;
    def.waterDensity = seaWaterDensity;
    FloatScene scene(def);
    const auto shape = [] { return std::make_unique<btBoxShape>(btVector3(1, 1, btScalar(0.5))); };
    btRigidBody& raft = scene.addBody(shape(), 2000, at({0, 0, 0.5}));
    scene.buoyancy().addBody(raft);
    scene.run(60, dt);
    EXPECT_NEAR(scene.buoyancy().report(raft).submergedVolume, 2000 / seaWaterDensity, 1e-4);
}

/// A visual mesh in place of the collision shape.
TEST(BuoyancyAction, AHullGivenByTheUserIsWettedInsteadOfTheShape) {
    FloatScene scene;
    btRigidBody& body = scene.addBody(std::make_unique<btSphereShape>(btScalar(0.1)), 500, at({0, 0, 0.3}));
    BodyDef def;
    def.hull = hullOf(boxMesh({2, 2, 1}));
    ASSERT_TRUE(scene.buoyancy().addBody(body, def));
    scene.run(60, dt);
    EXPECT_NEAR(scene.buoyancy().report(body).submergedVolume, 0.5, 1e-4);
    EXPECT_NEAR(heightAboveWater(body, scene.water()), 0.5 - 0.125, 1e-4);
}

/// A body that only drag acts on: neutrally buoyant, wholly under water.
TEST(Drag, DecaysExponentiallyAndNeverReverses) {
    for (double rate : {0.5, 3.0, 1e4})
        for (double step : {1.0 / 240, 1.0 / 60, 0.1}) {
            FloatScene scene;
            BodyDef def;
            def.linearDrag = rate;
            btRigidBody& box = scene.addFloatingBox({1, 1, 1}, 1, at({0, 0, -10}), def);
            box.setLinearVelocity({2, 0, 0});
            scene.run(1.2, step);
            const double velocity = double(scene.buoyancy().report(box).velocity.x());
            EXPECT_NEAR(velocity, 2 * std::exp(-rate * 1.2), 2e3 * poseRounding)
                << "rate " << rate << ", dt " << step;
            EXPECT_GE(velocity, 0);
            EXPECT_GE(box.getLinearVelocity().x(), 0);
        }
}

TEST(Drag, TerminalVelocityOfASinkingBodyDoesNotDependOnTheStep) {
    for (double step : {1.0 / 240, 1.0 / 60, 0.1}) {
        FloatScene scene;
        BodyDef def;
        def.linearDrag = 2;
        btRigidBody& box = scene.addFloatingBox({1, 1, 1}, 2, at({0, 0, -10}), def);
        scene.run(30, step);
        // The velocity between two substeps: what was set, and the gravity that Bullet is about to add.
        const double velocity = double(box.getLinearVelocity().z()) - step * standardGravity;
        EXPECT_NEAR(velocity, -standardGravity / 2 / 2, 1e3 * poseRounding)
            << step;  // (1 - 1/ratio) g / rate
    }
}

TEST(Drag, ScalesWithTheWetFractionUnlessToldNotTo) {
    for (bool scale : {true, false}) {
        FloatScene scene;
        BodyDef def;
        def.linearDrag = 1;
        def.scaleByWetFraction = scale;
        btRigidBody& raft = scene.addFloatingBox({4, 4, 1}, 0.25, at({0, 0, 0.25}), def);
        raft.setLinearVelocity({1, 0, 0});
        scene.run(1, dt);
        EXPECT_NEAR(double(scene.buoyancy().report(raft).velocity.x()), std::exp(scale ? -0.25 : -1.0),
                    100 * poseRounding)
            << scale;
    }
}

TEST(Drag, ThereIsNoneInTheAir) {
    FloatScene scene;
    btRigidBody& box = scene.addFloatingBox({1, 1, 1}, 0.5, at({0, 0, 100}));
    box.setLinearVelocity({5, 0, 0});
    box.setAngularVelocity({0, 0, 2});
    scene.run(1, dt);
    EXPECT_EQ(box.getLinearVelocity().x(), 5);
    EXPECT_NEAR(double(box.getAngularVelocity().z()), 2, 100 * poseRounding);
    EXPECT_FALSE(scene.buoyancy().report(box).modelled.linearDrag);
    EXPECT_EQ(scene.buoyancy().report(box).state, BodyState::dry);
}

TEST(Drag, TakesAFloatingBodyAlongWithTheCurrent) {
    SceneDef sceneDef;
    sceneDef.frame = WaterFrame::yUp();
    sceneDef.flowVelocityWorld = {0.4, 0, -0.3};
    FloatScene scene(sceneDef);
    btRigidBody& raft = scene.addFloatingBox({2, 0.5, 2}, 0.5, at({0, 0, 0}));
    raft.forceActivationState(ACTIVE_TAG);  // may sleep, but the current keeps it awake
    scene.run(30, dt);
    const btVector3 velocity = scene.report(raft).velocity;  // Bullet's also brings its rounded pose back
    EXPECT_NEAR(double(velocity.x()), 0.4, 1e-5);
    EXPECT_NEAR(double(velocity.z()), -0.3, 1e-5);
    EXPECT_TRUE(raft.isActive());
}

/// Without drag the sum of the energies is constant but for the error of the step, of order (w dt)^2.
TEST(Energy, OfAFrictionlessHeaveIsKept) {
    FloatScene scene;
    btRigidBody& slab = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0.2}), frictionless());
    scene.step(dt);
    const double start = scene.report(slab).totalEnergy();
    const double ofMotion = 0.5 * 4000 * standardGravity * 0.2 * 0.2;  // rho g A z^2 / 2
    const double omegaDt = std::sqrt(standardGravity / 0.5) * dt;
    for (int i = 0; i < 6000; ++i) {
        scene.step(dt);
        ASSERT_NEAR(scene.report(slab).totalEnergy(), start, ofMotion * omegaDt * omegaDt) << i;
    }
}

TEST(Factors, LockedAxesStayLocked) {
    FloatScene scene;
    Pose pose = at({0, 0, 0.3});
    pose.orientation = Eigen::AngleAxisd(0.4, Vec3::UnitY());
    btRigidBody& box = scene.addFloatingBox({1, 0.7, 0.5}, 0.5, pose, frictionless());
    box.setLinearFactor({0, 0, 1});
    box.setAngularFactor(btVector3(0, 1, 0));
    scene.run(5, dt);
    const Pose now = poseOf(box);
    EXPECT_EQ(box.getLinearVelocity().x(), 0);
    EXPECT_EQ(box.getLinearVelocity().y(), 0);
    EXPECT_NEAR(now.position.head<2>().norm(), 0, 0);
    EXPECT_LT(Vec3(now.orientation * Vec3::UnitY() - Vec3::UnitY()).norm(), 100 * poseRounding);
    EXPECT_GT(std::abs(now.position.z() - 0.3), 0.01);  // it does move where it may
}

/// About an axis of the world that is none of its own: torques that no one measures hold the body to it.
TEST(Factors, ALockedBodyTurnsSteadilyAboutTheAxisThatIsLeft) {
    FloatScene scene;
    Pose pose = at({0, 0, 50});
    pose.orientation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 0.5).normalized());
    btRigidBody& box = scene.addFloatingBox({1, 0.6, 0.2}, 0.5, pose, frictionless());
    box.setAngularFactor(btVector3(0, 0, 1));
    box.setAngularVelocity({0, 0, 2});
    box.setGravity({0, 0, 0});
    scene.run(20, dt);
    EXPECT_NEAR(double(box.getAngularVelocity().z()), 2, 1e-5);
    EXPECT_EQ(box.getAngularVelocity().x(), 0);
}

/// As a game respawns it: turned by hand, and given a spin.
TEST(ATeleportedBody, KeepsTheSpinItIsGiven) {
    FloatScene scene;
    btRigidBody& spar = scene.addFloatingBox({4, 0.4, 0.4}, 1, at({0, 0, -20}), frictionless());
    scene.run(1, dt);
    Pose pose = at({5, 0, -20});
    pose.orientation = Eigen::AngleAxisd(pi / 2, Vec3::UnitZ());
    spar.setWorldTransform(toTransform(pose));
    spar.setInterpolationWorldTransform(toTransform(pose));
    spar.updateInertiaTensor();
    spar.setAngularVelocity({1, 0, 0});
    scene.run(1, dt);
    EXPECT_NEAR(double(scene.buoyancy().report(spar).spin.x()), 1, 1e-5);
}

/// Bullet would damp the velocity that is to cancel gravity, and so make the body heavier.
TEST(BulletsLinearDamping, SlowsABodyButDoesNotWeighItDown) {
    FloatScene scene;
    auto shape = std::make_unique<btBoxShape>(btVector3(1, 1, btScalar(0.5)));
    btRigidBody& raft = scene.addBody(std::move(shape), 2000, at({0, 0, 0}));
    raft.setDamping(btScalar(0.5), 0);  // half of the velocity is lost in a second
    raft.setLinearVelocity({1, 0, 0});
    scene.buoyancy().addBody(raft, frictionless());
    scene.run(1, dt);
    EXPECT_NEAR(double(scene.buoyancy().report(raft).velocity.x()), 0.5, 100 * poseRounding);
    scene.run(60, dt);
    EXPECT_NEAR(scene.buoyancy().report(raft).wetFraction, 0.5, 1e-5);
}

TEST(Drag, DoesNotTurnABlowRound) {
    for (double rate : {10.0, 1000.0}) {
        FloatScene scene;
        BodyDef def;
        def.linearDrag = rate;
        btRigidBody& cube = scene.addFloatingBox({1, 1, 1}, 0.5, at({0, 0, -10}), def);
        scene.run(2, dt);
        cube.applyCentralImpulse({0, 0, -300});
        scene.step(dt);
        // It sank with what the drag left of the blow, or rises with its terminal velocity, g / rate.
        EXPECT_LE(double(scene.buoyancy().report(cube).velocity.z()), standardGravity / rate + 1e-6) << rate;
        scene.step(dt);
        EXPECT_LE(double(scene.buoyancy().report(cube).velocity.z()), standardGravity / rate + 1e-6) << rate;
    }
}

TEST(BodyReport, HasTheVelocityWithoutWhatIsToCancelGravity) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    scene.run(60, dt);
    EXPECT_NEAR(double(raft.getLinearVelocity().z()), standardGravity * dt, 1e-5);
    EXPECT_NEAR(double(scene.buoyancy().report(raft).velocity.z()), 0, 1e-5);
}

TEST(Sleep, OfABodyAtRestInStillWaterIsNotDisturbed) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0.02}));
    raft.forceActivationState(ACTIVE_TAG);
    scene.run(60, dt);
    ASSERT_FALSE(raft.isActive());
    const btTransform asleep = raft.getWorldTransform();
    scene.run(10, dt);
    EXPECT_FALSE(raft.isActive());
    EXPECT_EQ(raft.getWorldTransform(), asleep);
    EXPECT_EQ(scene.buoyancy().report(raft).state, BodyState::asleep);
    EXPECT_NEAR(double(asleep.getOrigin().z()), 0, 1e-3);  // it fell asleep at its draft
}

/// Slow, but not in balance: it rises, it does not rest.
TEST(Sleep, DoesNotComeWhileABodyCreepsToItsDraft) {
    FloatScene scene;
    BodyDef def;
    def.linearDrag = 50;
    btRigidBody& slab = scene.addFloatingBox({2, 2, 1}, 0.9, at({0, 0, -2}), def);
    slab.forceActivationState(ACTIVE_TAG);
    scene.run(300, dt);
    EXPECT_NEAR(scene.buoyancy().report(slab).submergedVolume, 3.6, 1e-3);
}

TEST(Sleep, DoesNotComeInTheMiddleOfASwing) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0.1}), frictionless());
    raft.forceActivationState(
        ACTIVE_TAG);  // its heave stays below the 0.8 m/s under which Bullet calls it still
    scene.run(30, dt);
    EXPECT_TRUE(raft.isActive());
}

/// Woken by a blow in the middle of a stepSimulation, Bullet gives no gravity for the rest of it.
TEST(Sleep, WakingInTheMiddleOfAStepDoesNotThrowTheBodyUp) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    scene.run(1, dt);
    raft.forceActivationState(ACTIVE_TAG);
    scene.run(10, dt);
    ASSERT_FALSE(raft.isActive());
    scene.world().setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            auto* body = static_cast<btRigidBody*>(world->getWorldUserInfo());
            if (!body->isActive()) body->activate();
        },
        &raft, true);
    const double before = heightAboveWater(raft, scene.water());
    for (int i = 0; i < 200; ++i) {
        scene.step(1.0 / 64, 8);
        // Each substep that the water was there and gravity was not lifted it by g dt^2, and gave it no
        // velocity.
        ASSERT_LT(std::abs(heightAboveWater(raft, scene.water()) - before), 8 * standardGravity / (512 * 512))
            << i;
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
