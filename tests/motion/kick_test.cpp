#include "bullet_buoyancy/motion/kick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/known_bodies.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double rounding = 100 * epsilon;
constexpr double dt = 0.1;
const Vec3 none = Vec3::Zero();

struct Case {
    Inertia inertia;
    Motion motion;
    Load load;

    explicit Case(Random& random) : inertia(randomInertia(random)), motion(randomMotion(random, inertia)) {
        load.force = random.inCube(20);
        load.torque = random.inCube(20);
        load.dragRate = std::pow(10, random.uniform(-2, 1.5));
        load.dampingRate = std::pow(10, random.uniform(-2, 1.5));
        load.mediumVelocity = random.inCube(2);
    }

    Dissipation kick() { return Kick(load, dt).apply(motion, inertia, load.force, load.torque); }
    Vec3 acceleration() const { return load.force / inertia.mass; }
    double energy() const { return kineticEnergy(motion, inertia); }
};

TEST(Kick, TwiceByTheSameLoadIsADampedStep) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        Case body(random);
        const Vec3 medium = body.load.mediumVelocity;
        const Vec3 velocity =
            medium +
            DampedStep(body.load.dragRate, dt).advance(body.motion.velocity - medium, body.acceleration());
        const Vec3 momentum =
            DampedStep(body.load.dampingRate, dt).advance(body.motion.momentum, body.load.torque);
        body.kick();
        body.kick();
        EXPECT_TRUE(isNear(body.motion.velocity, velocity, rounding * 10));
        EXPECT_TRUE(isNear(body.motion.momentum, momentum, rounding * (10 + momentum.norm())));
        const Vec3 spin = body.inertia.spin(body.motion.pose.orientation, body.motion.momentum);
        EXPECT_TRUE(isNear(body.motion.spin, spin, rounding * (10 + spin.norm())));
    }
}

TEST(Kick, OfABodyThatDoesNotTurnFreelyIsADampedStepOfItsSpin) {
    Random random(2);
    Case body(random);
    body.inertia.turnsFreely = false;
    body.inertia.angularFactor = {0, 0, 1};
    body.motion.setSpin(body.inertia, {0, 0, 3});
    const Vec3 change = body.inertia.spinChange(body.motion.pose.orientation, body.load.torque);
    const Vec3 spin = DampedStep(body.load.dampingRate, dt).advance(body.motion.spin, change);
    body.kick();
    body.kick();
    EXPECT_TRUE(isNear(body.motion.spin, spin, rounding * (3 + spin.norm())));
    EXPECT_EQ(body.motion.spin.head<2>(), none.head<2>());
}

TEST(Kick, TakesTheWorkOfTheLoadLessTheEnergyGained) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        Case body(random);
        const double before = body.energy();
        const Vec3 medium = body.load.mediumVelocity;
        const Vec3 travel =
            medium * dt / 2 +
            DampedStep(body.load.dragRate, dt / 2).travel(body.motion.velocity - medium, body.acceleration());
        const Vec3 turn = body.inertia.spin(
            body.motion.pose.orientation,
            DampedStep(body.load.dampingRate, dt / 2).travel(body.motion.momentum, body.load.torque));
        const double work = body.load.force.dot(travel) + body.load.torque.dot(turn);
        const double dissipated = body.kick().sum();
        EXPECT_NEAR(dissipated, work - (body.energy() - before),
                    rounding * (std::abs(work) + before + body.energy()));
    }
}

/// Of x' = rate of change(x), for the energy that a medium takes along with the motion.
template <typename RateOfChange>
Eigen::Vector4d integrate(Eigen::Vector4d x, double time, const RateOfChange& rate) {
    constexpr int steps = 500;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Eigen::Vector4d k1 = rate(x), k2 = rate(x + h / 2 * k1), k3 = rate(x + h / 2 * k2),
                              k4 = rate(x + h * k3);
        x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return x;
}

Eigen::Vector4d withEnergy(const Vec3& v, double energy) {
    return (Eigen::Vector4d() << v, energy).finished();
}

/// By the power of the drag, with the classical method of Runge and Kutta: at most 30/s over 1/500 of 0.05 s,
/// whose fourth power is 1e-10.
TEST(Kick, TakesTheEnergyThatTheDragDoes) {
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        Case body(random);
        const auto ofDrag = [&](const Eigen::Vector4d& x) {
            const Vec3 drag = body.load.dragRate * (x.head<3>() - body.load.mediumVelocity);
            return withEnergy(body.acceleration() - drag, body.inertia.mass * drag.dot(x.head<3>()));
        };
        const auto ofDamping = [&](const Eigen::Vector4d& x) {
            const Vec3 drag = body.load.dampingRate * x.head<3>();
            const Vec3 spin = body.inertia.spin(body.motion.pose.orientation, x.head<3>());
            return withEnergy(body.load.torque - drag, drag.dot(spin));
        };
        const Eigen::Vector4d linear = integrate(withEnergy(body.motion.velocity, 0), dt / 2, ofDrag);
        const Eigen::Vector4d angular = integrate(withEnergy(body.motion.momentum, 0), dt / 2, ofDamping);
        const double before = body.energy();
        const Dissipation dissipated = body.kick();
        const double tolerance = 1e-9 * (before + body.energy());
        EXPECT_NEAR(dissipated.byDrag, linear[3], tolerance);
        EXPECT_NEAR(dissipated.byDamping, angular[3], tolerance);
    }
}

TEST(Kick, InAMediumAtRestTakesEnergyFromAllThatMoves) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        Case body(random);
        body.load.mediumVelocity.setZero();
        const Dissipation dissipated = body.kick();
        EXPECT_GT(dissipated.byDrag, 0);
        EXPECT_GT(dissipated.byDamping, 0);
    }
}

TEST(Kick, InAMediumThatMovesGivesEnergyToABodyAtRest) {
    Load load;
    load.dragRate = 2;
    load.mediumVelocity = {1, 0, 0};
    Motion motion;
    const Dissipation dissipated = Kick(load, dt).apply(motion, Inertia(), none, none);
    EXPECT_NEAR(-dissipated.byDrag, kineticEnergy(motion, Inertia()), rounding);
    EXPECT_GT(motion.velocity.x(), 0);
    EXPECT_EQ(dissipated.byDamping, 0);
}

TEST(Kick, WithoutAMediumTakesNothing) {
    Random random(6);
    Case body(random);
    body.load.dragRate = body.load.dampingRate = 0;
    EXPECT_EQ(body.kick().sum(), 0);
}

TEST(Kick, LeavesABodyAtItsTerminalVelocity) {
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        Case body(random);
        const Vec3 terminal = body.load.mediumVelocity + body.acceleration() / body.load.dragRate;
        const Vec3 terminalMomentum = body.load.torque / body.load.dampingRate;
        body.motion.velocity = terminal;
        body.motion.setMomentum(body.inertia, terminalMomentum);
        body.kick();
        EXPECT_TRUE(isNear(body.motion.velocity, terminal, rounding * (1 + terminal.norm())));
        EXPECT_TRUE(isNear(body.motion.momentum, terminalMomentum, rounding * terminalMomentum.norm()));
    }
}

TEST(Kick, BringsABodyThereAtOnceWhereTheDragIsStrong) {
    Random random(8);
    Case body(random);
    body.load.dragRate = 1e4;
    const Vec3 terminal = body.load.mediumVelocity + body.acceleration() / 1e4;
    body.kick();
    EXPECT_TRUE(isNear(body.motion.velocity, terminal, rounding * terminal.norm()));
}

/// What drag takes of a load in a step is handed over as well.
TEST(Kick, GivesABodyThatIsHeldItsWholeLoad) {
    Random random(9);
    Case body(random);
    body.motion.velocity.setZero();
    body.motion.setMomentum(body.inertia, none);
    body.load.mediumVelocity.setZero();
    body.kick();
    Kick last(body.load, dt);
    last.extraForce = last.linear.lostInTwoSteps();
    last.extraTorque = last.angular.lostInTwoSteps();
    const Dissipation dissipated = last.apply(body.motion, body.inertia, body.load.force, body.load.torque);
    const double force = body.load.force.norm(), torque = body.load.torque.norm();
    EXPECT_TRUE(isNear(body.inertia.mass * body.motion.velocity, dt * body.load.force, rounding * force));
    EXPECT_TRUE(isNear(body.motion.momentum, dt * body.load.torque, rounding * torque));
    EXPECT_EQ(dissipated.sum(), 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
