#include "bullet_buoyancy/motion/free_flight.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/motion/energy.h"
#include "support/known_bodies.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double rounding = 30 * epsilon;  // of a few products of rotations

double turnBetween(const Pose& a, const Pose& b) {
    return 2 * std::asin(std::min(1.0, (a.orientation.conjugate() * b.orientation).vec().norm()));
}

/// As a body is whose angular factor is not 1.
Inertia heldAbout(const Vec3& angularFactor, Inertia inertia) {
    inertia.angularFactor = angularFactor;
    inertia.turnsFreely = false;
    return inertia;
}

TEST(Inertia, SpinAndMomentumAreInverse) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Inertia inertia = randomInertia(random);
        const Eigen::Quaterniond orientation = random.orientation();
        const Vec3 spin = random.inCube(10);
        const double spread = inertia.principal.maxCoeff() / inertia.principal.minCoeff();
        EXPECT_TRUE(isNear(inertia.spin(orientation, inertia.momentum(orientation, spin)), spin,
                           rounding * spread * spin.norm()));
    }
}

/// A published version forgets the orientation; only a cube hides that.
TEST(Inertia, TurnsWithTheBody) {
    const Inertia inertia = withInertia(1, {1, 2, 3});
    const Eigen::Quaterniond quarter(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));
    EXPECT_TRUE(isNear(inertia.momentum(quarter, Vec3::UnitX()), Vec3(2, 0, 0), rounding));
    EXPECT_TRUE(isNear(inertia.momentum(quarter, Vec3::UnitY()), Vec3(0, 1, 0), rounding));
    EXPECT_TRUE(isNear(inertia.spin(quarter, Vec3::UnitX()), Vec3(0.5, 0, 0), rounding));
    EXPECT_TRUE(isNear(inertia.spinChange(quarter, Vec3::UnitZ()), Vec3(0, 0, 1. / 3), rounding));
}

TEST(Inertia, AboutAnAxisWithoutOneGivesNoSpin) {
    Inertia inertia = withInertia(1, {1, 2, 3});
    inertia.principal.y() = inertia.inversePrincipal.y() = 0;
    const Eigen::Quaterniond quarter(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));  // the body's y is -x
    EXPECT_TRUE(isNear(inertia.spinChange(quarter, {7, 0, 0}), Vec3(0, 0, 0), 7 * rounding));
    EXPECT_TRUE(isNear(inertia.spinChange(quarter, {7, 1, 3}), Vec3(0, 1, 1), 7 * rounding));
}

TEST(Inertia, LetsAnImpulseMoveABodyByTheSharesOfItsFactors) {
    Inertia inertia = heldAbout({1, 0, 0.5}, withInertia(2, {1, 2, 3}));
    inertia.linearFactor = {1, 0.5, 0};
    EXPECT_EQ(inertia.velocityChange({2, 2, 2}), Vec3(1, 0.5, 0));
    // A factor counts twice: for what a torque does, and for the spin that it gives.
    EXPECT_EQ(inertia.spinChange(Eigen::Quaterniond::Identity(), {1, 2, 3}), Vec3(1, 0, 0.25));
}

TEST(Motion, HasTheKineticEnergyOfTheTensor) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const Inertia inertia = randomInertia(random);
        const Motion motion = randomMotion(random, inertia);
        const Mat3 turn = motion.pose.worldFromBody();
        const Mat3 tensor = turn * inertia.principal.asDiagonal() * turn.transpose();
        const double ofRotation = motion.spin.dot(tensor * motion.spin) / 2;
        const double total = ofRotation + inertia.mass * motion.velocity.squaredNorm() / 2;
        EXPECT_NEAR(rotationalEnergy(motion.momentum, motion.spin), ofRotation, rounding * total);
        EXPECT_NEAR(kineticEnergy(motion, inertia), total, rounding * total);
    }
}

TEST(Motion, GainsAnImpulse) {
    Random random(3);
    const Inertia inertia = randomInertia(random);
    const Motion before = randomMotion(random, inertia);
    Motion after = before;
    after.push(inertia, {1, -2, 3}, {0.5, 0, -4});
    EXPECT_EQ(after.velocity, before.velocity + Vec3(1, -2, 3) / inertia.mass);
    EXPECT_EQ(after.momentum, before.momentum + Vec3(0.5, 0, -4));
    EXPECT_EQ(after.spin, inertia.spin(after.pose.orientation, after.momentum));
}

TEST(Motion, TakenElsewhereKeepsItsMomentum) {
    Random random(4);
    const Inertia inertia = randomInertia(random);
    Motion motion = randomMotion(random, inertia);
    const Vec3 momentum = motion.momentum, velocity = motion.velocity;
    motion.moveTo(inertia, {random.inCube(1), random.orientation()});
    EXPECT_EQ(motion.momentum, momentum);
    EXPECT_EQ(motion.velocity, velocity);
    EXPECT_EQ(motion.spin, inertia.spin(motion.pose.orientation, momentum));
}

/// The torques that hold it change its momentum as they must.
TEST(Motion, OfABodyThatDoesNotTurnFreelyKeepsItsSpin) {
    Random random(5);
    const Inertia inertia = heldAbout({0, 0, 1}, randomInertia(random));
    Motion motion = randomMotion(random, inertia);
    motion.setSpin(inertia, {0, 0, 2});
    motion = fly(motion, inertia, 0.1, Turning::atSpin);
    EXPECT_EQ(motion.spin, Vec3(0, 0, 2));
    EXPECT_EQ(motion.momentum, inertia.momentum(motion.pose.orientation, motion.spin));
    motion.push(inertia, Vec3::Zero(), {1, 1, 0});
    EXPECT_EQ(motion.spin.x(), 0);
    EXPECT_EQ(motion.spin.y(), 0);
}

/// To rounding; in small turns, whose direction is a series', to its error of a tenth of their fifth power.
TEST(FreeFlight, KeepsEnergyAndMomentumHoweverFarItTurns) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Inertia inertia = randomInertia(random);
        Motion motion = randomMotion(random, inertia);
        motion.setSpin(inertia, std::pow(10, random.uniform(-2, 3)) * random.direction());
        const double limit = random.coin() ? largestTurn : random.uniform(0, largestTurn);
        const Motion arrival = fly(motion, inertia, 1.0 / 60, Turning::byMomentum, limit);
        const double energy = kineticEnergy(motion, inertia), angle = motion.spin.norm() / 60;
        const double series = angle < 0.02 ? 0.1 * std::pow(angle, 5) : 0;
        const double sensitivity = motion.momentum.norm() * motion.spin.norm();
        EXPECT_NEAR(kineticEnergy(arrival, inertia), energy, 1e-13 * energy + series * sensitivity);
        EXPECT_EQ(arrival.momentum, motion.momentum);
        EXPECT_LE(turnBetween(motion.pose, arrival.pose), limit * (1 + 1e-12));
    }
}

TEST(FreeFlight, OfABodyThatSpinsTooFastGoesAsFarAsItMay) {
    const Inertia inertia = withInertia(1, {1, 2, 2.5});
    Motion motion;
    for (double speed : {1e2, 1e3, 1e4}) {
        motion.setSpin(inertia, speed * Vec3(1, 1, 1));
        const double turn =
            turnBetween(motion.pose, fly(motion, inertia, 1.0 / 60, Turning::byMomentum).pose);
        EXPECT_LE(turn, largestTurn);
        EXPECT_GT(turn, 0.8 * largestTurn);
        EXPECT_NEAR(turnBetween(motion.pose, fly(motion, inertia, 1.0 / 60, Turning::atSpin).pose),
                    largestTurn, 1e-12);
    }
}

double gainAtSpin(const Motion& start, const Inertia& inertia, int steps) {
    Motion motion = start;
    for (int i = 0; i < steps; ++i)
        motion = fly(motion, inertia, 1.0 / steps, Turning::atSpin);
    EXPECT_EQ(motion.momentum, start.momentum);
    return kineticEnergy(motion, inertia) - kineticEnergy(start, inertia);
}

double errorAtSpin(const Motion& start, const Inertia& inertia, int steps) {
    Motion published = start, exact = start;
    for (int i = 0; i < steps; ++i) {
        published = fly(published, inertia, 1.0 / steps, Turning::atSpin);
        exact = fly(exact, inertia, 1.0 / steps, Turning::byMomentum);
    }
    return turnBetween(published.pose, exact.pose);
}

/// Half the step, half the error, to a share of the order of the step: 3 rad in 1000 steps.
TEST(FreeFlight, AtTheSpinOfItsStartIsOfFirstOrder) {
    const Inertia inertia = withInertia(1, {1, 2, 2.5});
    Motion start;
    start.setSpin(inertia, {1, 2, 2});
    EXPECT_NEAR(errorAtSpin(start, inertia, 1000) / errorAtSpin(start, inertia, 2000), 2, 0.02);
    EXPECT_NEAR(gainAtSpin(start, inertia, 1000) / gainAtSpin(start, inertia, 2000), 2, 0.02);
    EXPECT_GT(gainAtSpin(start, inertia, 1000), 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
