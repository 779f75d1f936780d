#include "bullet_buoyancy/motion/angular_momentum.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/motion/energy.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double rounding = 1e-13;  // of a few products of rotations in double precision
constexpr double dt = 1.0 / 60;

RotationalInertia randomInertia(Random& random) {
    const Vec3 principal{random.uniform(0.1, 1), random.uniform(1, 2), random.uniform(2, 3)};
    return {random.orientation().toRotationMatrix(), principal};
}

RotationalInertia turned(const RotationalInertia& inertia, const Vec3& spin, double time) {
    return inertia.beforeTurning(spin, -time);
}

/// A body as an engine has it: it turns with the spin it is given.
struct Engine {
    RotationalInertia inertia;
    Vec3 spin;

    void turn(double time) { inertia = turned(inertia, spin, time); }
};

TEST(RotationalInertia, SpinAndMomentumAreInverse) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const RotationalInertia inertia = randomInertia(random);
        const Vec3 spin = random.inCube(10);
        EXPECT_LT((inertia.spin(inertia.momentum(spin)) - spin).norm(), rounding * 10);
    }
}

/// A published version forgets the orientation; only a cube hides that.
TEST(RotationalInertia, TurnsWithTheBody) {
    const RotationalInertia inertia{Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()).toRotationMatrix(), {1, 2, 3}};
    EXPECT_LT((inertia.momentum(Vec3::UnitX()) - 2 * Vec3::UnitX()).norm(), rounding);
    EXPECT_LT((inertia.momentum(Vec3::UnitY()) - 1 * Vec3::UnitY()).norm(), rounding);
}

TEST(RotationalInertia, TurningBackUndoesATurn) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const RotationalInertia inertia = randomInertia(random);
        const Vec3 spin = random.inCube(5);
        const RotationalInertia there = turned(inertia, spin, dt), back = there.beforeTurning(spin, dt);
        EXPECT_LT((back.worldFromBody - inertia.worldFromBody).norm(), rounding);
    }
}

TEST(AngularMomentum, StartsWithTheSpinAtTheOrientationBeforeTheFirstTurn) {
    Random random(3);
    Engine engine{randomInertia(random), random.inCube(5)};
    const Vec3 momentum = engine.inertia.momentum(engine.spin);
    engine.turn(dt);
    AngularMomentum keeper;
    keeper.restart(engine.inertia, engine.spin, dt);
    EXPECT_LT((keeper.value() - momentum).norm(), rounding * momentum.norm());
}

TEST(AngularMomentum, IsConstantWithoutTorqueWhateverTheBodyDoes) {
    Random random(4);
    Engine engine{randomInertia(random), random.inCube(5)};
    AngularMomentum keeper;
    keeper.restart(engine.inertia, engine.spin, 0);
    const Vec3 start = keeper.value();
    for (int i = 0; i < 10000; ++i) {
        keeper.step(Vec3::Zero(), 0, dt);
        engine.spin = engine.inertia.spin(keeper.value());
        keeper.handOver(engine.inertia, engine.spin);
        engine.turn(dt);
        keeper.absorb(engine.inertia, engine.spin, dt);
    }
    EXPECT_EQ(keeper.value(), start);
}

TEST(AngularMomentum, DecaysAtItsRateAtAnyStep) {
    for (double step : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
        Random random(5);
        Engine engine{randomInertia(random), random.inCube(5)};
        AngularMomentum keeper;
        keeper.restart(engine.inertia, engine.spin, 0);
        const Vec3 start = keeper.value();
        const double rate = 0.7, seconds = 4;
        for (long i = 0; i < std::lround(seconds / step); ++i) {
            keeper.step(Vec3::Zero(), rate, step);
            engine.spin = engine.inertia.spin(keeper.value());
            keeper.handOver(engine.inertia, engine.spin);
            engine.turn(step);
            keeper.absorb(engine.inertia, engine.spin, step);
        }
        EXPECT_LT((keeper.value() - std::exp(-rate * seconds) * start).norm(), 1e-11 * start.norm()) << step;
    }
}

TEST(AngularMomentum, TakesInABlowAtTheOrientationItFellAt) {
    Random random(6);
    Engine engine{randomInertia(random), random.inCube(5)};
    AngularMomentum keeper;
    keeper.restart(engine.inertia, engine.spin, 0);
    keeper.handOver(engine.inertia, engine.spin);
    const Vec3 before = keeper.value(), impulse = random.inCube(2);
    engine.spin += engine.inertia.spin(impulse);  // solved for before the engine turns the body
    engine.turn(dt);
    keeper.absorb(engine.inertia, engine.spin, dt);
    EXPECT_LT((keeper.value() - before - impulse).norm(), rounding * 10);
}

TEST(AngularMomentum, FollowsAChangeOfInertiaAtTheSameSpin) {
    Random random(7);
    Engine engine{randomInertia(random), random.inCube(5)};
    AngularMomentum keeper;
    keeper.restart(engine.inertia, engine.spin, 0);
    keeper.handOver(engine.inertia, engine.spin);
    engine.inertia.principal *= 3;
    const Vec3 momentum = engine.inertia.momentum(engine.spin);
    engine.turn(dt);
    keeper.absorb(engine.inertia, engine.spin, dt);
    EXPECT_LT((keeper.value() - momentum).norm(), rounding * momentum.norm());
}

TEST(AngularMomentum, GainsTheTorqueTimesTheStep) {
    AngularMomentum keeper;
    keeper.step({1, -2, 3}, 0, 0.25);
    keeper.addImpulse({1, 1, 1});
    EXPECT_EQ(keeper.value(), Vec3(1.25, 0.5, 1.75));
}

TEST(AngularMomentum, OfABodyTurnedByHandStartsAnewWithItsSpin) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        Engine engine{randomInertia(random), random.inCube(5)};
        AngularMomentum keeper;
        keeper.restart(engine.inertia, engine.spin, 0);
        keeper.handOver(engine.inertia, engine.spin);
        engine.inertia.worldFromBody = random.orientation().toRotationMatrix();
        engine.spin = random.inCube(5);
        const Vec3 momentum = engine.inertia.momentum(engine.spin);
        engine.turn(dt);
        keeper.absorb(engine.inertia, engine.spin, dt);
        EXPECT_LT((keeper.value() - momentum).norm(), 10 * rounding * momentum.norm());
    }
}

TEST(Energy, OfRotationIsThatOfTheTensor) {
    Random random(9);
    const RotationalInertia inertia = randomInertia(random);
    const Vec3 spin = random.inCube(3);
    const Mat3 tensor =
        inertia.worldFromBody * inertia.principal.asDiagonal() * inertia.worldFromBody.transpose();
    EXPECT_NEAR(rotationalEnergy(inertia.momentum(spin), spin), spin.dot(tensor * spin) / 2, rounding * 100);
}

}  // namespace
}  // namespace bullet_buoyancy::test
