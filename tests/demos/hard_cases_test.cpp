#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "bullet_buoyancy/core/constants.h"
#include "scenes/capsizing.h"
#include "scenes/cargo.h"
#include "scenes/current.h"
#include "scenes/dropped_body.h"
#include "scenes/faulty_meshes.h"
#include "scenes/harbour.h"
#include "scenes/heave.h"
#include "scenes/random_bodies.h"
#include "scenes/rigid_rotation.h"
#include "scenes/surroundings.h"
#include "scenes/tumbling.h"

/// What demos/hard_cases prints, thinned; the limits and their reasons are those of the cases there.
namespace bullet_buoyancy::scenes {
namespace {

constexpr double riseLimit = 1.001, energyLimit = 1e-3;

void expectNoRise(const DropDef& def, double seconds) {
    const FallResult fall = fallUndamped(def, seconds);
    EXPECT_TRUE(fall.finite);
    EXPECT_LE(fall.rise, riseLimit);
    EXPECT_LE(fall.energyGain, energyLimit);
    EXPECT_LE(fall.motion, riseLimit * motionShown(def));
}

void expectRest(const DropDef& def) {
    const SettleResult rest = settle(def, 30000);
    EXPECT_TRUE(rest.finite);
    EXPECT_TRUE(rest.atRest);
    EXPECT_LE(rest.wetError, wetErrorLimit(def));
}

TEST(HardCases, ACubeOfAnyDensitySizeAndStepNeverRisesAboveItsDropAndSettles) {
    for (double ratio : {1e-3, 0.1, 0.9})
        for (double edge : {0.05, 1.0})
            for (double dt : {1.0 / 60, 0.1}) {
                SCOPED_TRACE(testing::Message() << "ratio " << ratio << ", " << edge << " m, " << dt << " s");
                DropDef def;
                def.ratio = ratio;
                def.size = Vec3::Constant(edge);
                def.height = 2 * edge;
                def.orientation = askew();
                def.stepping.dt = dt;
                expectNoRise(def, 10);
                expectRest(def);
            }
}

TEST(HardCases, ANeedleAndAPlateNeverRiseAboveTheirDrop) {
    for (const Vec3& size : {Vec3(0.05, 0.05, 5), Vec3(5, 5, 0.05)})
        for (double ratio : {0.01, 0.5}) {
            SCOPED_TRACE(testing::Message() << size.transpose() << " m, ratio " << ratio);
            DropDef def;
            def.size = size;
            def.ratio = ratio;
            def.height = 5;
            def.orientation = askew();
            expectNoRise(def, 10);
        }
}

TEST(HardCases, AFallAtHundredMetresASecondGainsNothing) {
    DropDef def;
    def.ratio = 0.1;
    def.downwardSpeed = 100;
    def.orientation = askew();
    expectNoRise(def, 60);
    expectRest(def);
}

TEST(HardCases, ALightBallFromTheDepthRisesAsHighAsItsEnergyAllows) {
    DropDef def;
    def.solid = Solid::sphere;
    def.size = Vec3::Constant(0.3);
    def.ratio = 0.01;
    def.height = -100;
    expectNoRise(def, 60);
    def.height = -1000;
    for (double dt : {1.0 / 60, 0.1}) {
        def.stepping.dt = dt;
        EXPECT_LE(terminalVelocityError(def, 300), 1e-4) << dt;
    }
}

/// I = (1, 2, 3), omega = (1, 0, 1): Jacobi's elliptic functions at t = 1.
TEST(RigidRotation, IsThatOfTheClosedForm) {
    const FreeRotation end = rotateFreely({Eigen::Quaterniond::Identity(), {1, 0, 1}}, {1, 2, 3}, 1, 1000);
    EXPECT_LT((end.spin - Vec3(0.5778024718, 0.8161766375, 0.8820158155)).norm(), 1e-9);
    const Eigen::Quaterniond expected(0.7790396026, 0.3582092660, 0.1958299707, 0.4758508610);
    EXPECT_LT(end.orientation.angularDistance(expected), 1e-8);
}

TEST(HardCases, AFastSpinKeepsItsEnergyAndFollowsTheReference) {
    TumbleDef rod;
    const TumbleError error = tumble(rod);
    const double reading = std::pow(rod.spin.norm() * rod.stepping.dt, 2) / 6 + 2e-4;
    EXPECT_LE(error.energy, energyLimit);
    EXPECT_LE(error.momentum, reading);
    EXPECT_LE(error.direction, reading);
    EXPECT_LE(error.orientation, 0.05);

    TumbleDef flip;
    flip.halfExtents = {0.1, 0.3, 0.5};
    flip.spin = {0.01, 5, 0.01};
    const TumbleError flipped = tumble(flip);
    EXPECT_LE(flipped.energy, energyLimit);
    EXPECT_LE(flipped.orientation, 0.1);
}

TEST(HardCases, DragOfAnyStrengthApproachesTheCurrentFromOneSide) {
    for (double ratio : {1.0, 0.5}) {
        DriftDef def;
        def.ratio = ratio;
        const CurrentResult result = driftInCurrent(def);
        EXPECT_TRUE(result.finite) << ratio;
        EXPECT_LE(result.overshoot, 1e-6) << ratio;
        EXPECT_LE(result.remaining, 1e-6) << ratio;
    }
}

TEST(HardCases, AFrictionlessHeaveKeepsItsAmplitudeAndPeriod) {
    for (const auto& [dt, amplitude, period] :
         {std::tuple(1.0 / 60, 0.005, 1e-3), std::tuple(1.0 / 30, 0.015, 5e-3)}) {
        HeaveDef def;
        def.stepping.dt = dt;
        const HeaveError error = heaveFreely(def);
        EXPECT_LE(std::abs(error.amplitudeLost), amplitude) << dt;
        EXPECT_LE(error.period, period) << dt;
    }
}

TEST(HardCases, RaftsCarryTheirCargo) {
    for (const CargoResult& result :
         {stackCratesOnRaft(Floater::library), loadInflatableRaft(Floater::library)}) {
        EXPECT_TRUE(result.finite);
        EXPECT_LE(result.displacementError, 0.01);
        EXPECT_LE(result.worstShift, 0.4);
        EXPECT_LE(result.worstHeightError, 0.15);
        EXPECT_LE(result.tilt, 0.02);
    }
}

TEST(HardCases, ChainedBarrelsHoldTogetherAndComeToRest) {
    const ChainResult result = chainBarrels(Floater::library);
    EXPECT_TRUE(result.finite);
    EXPECT_LE(result.widestGap, 0.05);
    EXPECT_LE(result.highest, 0.4);
    EXPECT_LE(result.speed, 0.02);
}

TEST(HardCases, WallsBeachAndDeckHoldWhatTheWaterPressesToThem) {
    for (const HeldResult& result :
         {wedgeCrate(Floater::library), beach(0.05, Floater::library), beach(0.5, Floater::library)}) {
        EXPECT_TRUE(result.finite);
        EXPECT_LE(result.highest, 0.05);
        EXPECT_LE(result.deepest, 0.02);
        EXPECT_LE(result.speed, 0.02);
    }
    const DeckResult deck = holdUnderDeck(Floater::library);
    EXPECT_TRUE(deck.held.finite);
    EXPECT_LE(deck.held.deepest, 0.02);
    EXPECT_LE(deck.rise, riseLimit);
    EXPECT_TRUE(deck.settled);
    EXPECT_LE(deck.wetError, 0.01);
}

TEST(HardCases, AHullCapsizesIfAndOnlyIfItsMetacentreIsBelowItsMass) {
    for (double raised : {0.25, 0.8}) {
        CapsizeDef def;
        def.raised = raised;
        const CapsizeResult result = heelHull(def);
        EXPECT_TRUE(result.finite);
        if (result.metacentricHeight > 0) {
            EXPECT_LE(result.mostHeel, 1.1 * def.heel);
            EXPECT_LE(result.endHeel, 0.01);
        } else {
            EXPECT_GT(result.endHeel, pi / 2);
        }
    }
}

TEST(HardCases, AFaultyMeshIsRefusedOrNamedOrFloatsRight) {
    for (const FaultyMesh& faulty : faultyMeshes()) {
        const FaultyResult result = floatFaulty(faulty, Floater::library);
        EXPECT_TRUE(result.finite) << faulty.fault;
        EXPECT_TRUE(result.refused || result.remarked || result.draftError < 1e-3) << faulty.fault;
        EXPECT_LE(result.balanceError, 2e-3) << faulty.fault;
    }
}

TEST(HardCases, FarFromTheOriginBodiesFloatAsWellAsBulletCanPlaceThem) {
    DropDef def;
    def.scene.frame = WaterFrame::zUp({1e4, 1e4, 1e4});
    const double rounding = positionRounding(def) / def.height;
    const FallResult fall = fallUndamped(def, 20);
    EXPECT_TRUE(fall.finite);
    EXPECT_LE(fall.rise, riseLimit + 2 * rounding * std::sqrt(20 * 60) + rounding);
    const SettleResult rest = settle(def, 600);
    EXPECT_TRUE(rest.atRest);
    EXPECT_LE(rest.wetError, wetErrorLimit(def, BodyDef{}));
}

TEST(HardCases, NoAxisOfGravityIsSpecial) {
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {1.0, -1.0})
            EXPECT_LE(differenceOfUps(sign * Vec3::Unit(axis), 3, Floater::library), 3e4 * bulletRounding)
                << axis << ", " << sign;
    EXPECT_LE(driftWithoutGravity(Floater::library), 10 * bulletRounding);
}

TEST(HardCases, UnevenStepsLetNothingRise) {
    DropDef def;
    def.orientation = askew();
    def.stepping.dt = 0.1;
    def.shortestStep = 1.0 / 240;
    expectNoRise(def, 60);
}

TEST(HardCases, OneSubstepAgreesWithEight) {
    constexpr double dt = 1.0 / 60;
    const double w = std::sqrt(standardGravity / 0.5);
    const double phase = w * 5 * std::pow(w * dt, 2) / 24 + w * dt / 2;
    EXPECT_LE(differenceOfSubsteps(dt, Floater::library), 0.1 * phase + standardGravity * dt * dt);
}

TEST(HardCases, NoBodyOfManyGainsEnergy) {
    RandomBodiesDef def;
    def.bodies = 300;
    def.seed = 2;
    const RandomBodiesResult result = dropRandomBodies(def);
    EXPECT_EQ(result.notFinite, 0);
    EXPECT_LE(result.worstGain, energyLimit) << "body " << result.worstBody;
}

}  // namespace
}  // namespace bullet_buoyancy::scenes
