#include "bullet_buoyancy/motion/body_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/motion/free_rotation.h"
#include "support/engine.h"
#include "support/near.h"
#include "support/simple_loads.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double rounding = 100 * epsilon;
constexpr double dt = 1.0 / 60;
const Weight nothing;

Engine flying(Random& random) {
    Engine engine(randomInertia(random), nothing, dt);
    engine.start(randomMotion(random, engine.inertia));
    return engine;
}

TEST(BodyMotion, DepartsAtTheVelocityThatCarriesTheBodyToItsTarget) {
    Random random(1);
    Engine engine = flying(random);
    engine.depart();
    const Vec3 travel = engine.body.target().position - engine.pose().position;
    EXPECT_TRUE(isNear(travel, dt * engine.body.departure().velocity, rounding));
    EXPECT_EQ(
        engine.body.target().orientation.coeffs(),
        fly(engine.body.departure(), engine.inertia, dt, Turning::byMomentum).pose.orientation.coeffs());
}

/// Each step rounds it once.
TEST(BodyMotion, KeepsMomentumVelocityAndEnergyWhateverTheBodyDoes) {
    Random random(2);
    Engine engine = flying(random);
    const Motion start = engine.motion();
    const double energy = engine.energy();
    constexpr int steps = 10000;
    engine.steps(steps);
    const double tolerance = steps * epsilon;
    EXPECT_TRUE(isNear(engine.motion().momentum, start.momentum, tolerance * start.momentum.norm()));
    EXPECT_TRUE(isNear(engine.motion().velocity, start.velocity, tolerance * start.velocity.norm()));
    EXPECT_NEAR(engine.energy(), energy, 10 * tolerance * energy);
    const double spread = (engine.motion().spin - start.spin).norm();
    EXPECT_GT(spread, 0.01 * start.spin.norm());  // it did something
}

TEST(BodyMotion, SlowsAtItsRatesAtAnyStep) {
    Weight water;
    water.medium.dragRate = 0.3;
    water.medium.dampingRate = 0.7;
    for (double step : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
        Random random(3);
        Engine engine(randomInertia(random), water, step);
        const Motion start = randomMotion(random, engine.inertia);
        engine.start(start);
        const double seconds = 4;
        const int steps = int(std::lround(seconds / step));
        engine.steps(steps);
        EXPECT_TRUE(isNear(engine.motion().momentum, std::exp(-0.7 * seconds) * start.momentum,
                           4 * steps * epsilon * start.momentum.norm()));
        EXPECT_TRUE(isNear(engine.motion().velocity, std::exp(-0.3 * seconds) * start.velocity,
                           4 * steps * epsilon * start.velocity.norm()));
    }
}

TEST(BodyMotion, FallsAsItShould) {
    Random random(4);
    const Inertia inertia = randomInertia(random);
    const Weight weight(9.8 * inertia.mass);
    Engine engine(inertia, weight, dt);
    const Motion start = randomMotion(random, inertia);
    engine.start(start);
    engine.steps(600);
    const double height = start.pose.position.z() + 10 * start.velocity.z() - 9.8 * 50;
    EXPECT_NEAR(engine.height(), height, 600 * rounding * 10);
    EXPECT_NEAR(engine.motion().velocity.z(), start.velocity.z() - 98, 600 * rounding * 10);
}

TEST(BodyMotion, TakesInABlowAtTheOrientationItFellAt) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        Engine engine = flying(random);
        const Motion before = engine.motion();
        const Vec3 impulse = random.inCube(2), angularImpulse = random.inCube(2);
        engine.step(impulse, angularImpulse);
        EXPECT_TRUE(isNear(engine.motion().velocity, before.velocity + impulse / engine.inertia.mass,
                           rounding * before.velocity.norm()));
        EXPECT_TRUE(isNear(engine.motion().momentum, before.momentum + angularImpulse,
                           rounding * (2 + before.momentum.norm())));
    }
}

TEST(BodyMotion, BooksABlowToOthersExactly) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        Engine engine = flying(random);
        engine.steps(10);
        const double before = engine.energy();
        engine.step(random.inCube(2), random.inCube(2));
        engine.steps(10);
        const EnergyLedger& ledger = engine.body.ledger();
        EXPECT_NEAR(ledger.byOthers, engine.energy() - before, 20 * rounding * (before + engine.energy()));
        EXPECT_NEAR(ledger.expected(), engine.energy(), 20 * rounding * (before + engine.energy()));
        EXPECT_NE(ledger.byOthers, 0);
    }
}

TEST(BodyMotion, FollowsAChangeOfInertiaAtTheSameSpin) {
    Random random(7);
    Engine engine = flying(random);
    engine.depart();
    const Vec3 spin = engine.body.departure().spin, velocity = engine.body.departure().velocity;
    engine.inertia = withInertia(7, 3 * engine.inertia.principal);
    Disturbance reweighed;
    reweighed.turnedByHand = true;
    const Pose pose = engine.body.target();
    engine.body.arriveElsewhere(engine.inertia, pose, reweighed);
    engine.settle();
    const Vec3 momentum = engine.inertia.momentum(pose.orientation, spin);
    EXPECT_TRUE(isNear(engine.motion().momentum, momentum, rounding * momentum.norm()));
    EXPECT_EQ(engine.motion().velocity, velocity);
}

TEST(BodyMotion, TurnedByHandGoesOnAtItsSpin) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        Engine engine = flying(random);
        engine.depart();
        Disturbance hand;
        hand.spinChange = random.inCube(2);
        hand.turnedByHand = true;
        const Pose pose{random.inCube(3), random.orientation()};
        const Vec3 spin = engine.body.departure().spin + hand.spinChange;
        engine.body.arriveElsewhere(engine.inertia, pose, hand);
        engine.settle();
        EXPECT_EQ(engine.pose().position, pose.position);
        EXPECT_TRUE(isNear(engine.motion().spin, spin, rounding * spin.norm() * 10));
        EXPECT_TRUE(isNear(engine.motion().momentum, engine.inertia.momentum(pose.orientation, spin),
                           rounding * engine.motion().momentum.norm()));
    }
}

/// Told one length of a step and then another, a body moves as if it had been told the other at once.
TEST(BodyMotion, DepartedAgainIsAsIfItHadNotDepartedBefore) {
    Random random(9);
    const Spring spring(50);
    const Inertia inertia = randomInertia(random);
    const Motion start = randomMotion(random, inertia);
    Engine once(inertia, spring, 1.7 * dt), twice(inertia, spring, dt);
    once.start(start);
    twice.start(start);
    twice.depart();
    twice.dt = once.dt;
    twice.body.departAgain(inertia, twice.def, spring, twice.dt);
    twice.body.arrive();
    twice.settle();
    once.step();
    EXPECT_EQ(once.pose().position, twice.pose().position);
    EXPECT_EQ(once.pose().orientation.coeffs(), twice.pose().orientation.coeffs());
    EXPECT_EQ(once.motion().velocity, twice.motion().velocity);
    EXPECT_EQ(once.body.ledger().expected(), twice.body.ledger().expected());
}

TEST(BodyMotion, StartedAnewForgetsThePast) {
    Random random(10);
    Engine engine = flying(random);
    engine.step({1, 2, 3}, {3, 2, 1});
    const Motion fresh = randomMotion(random, engine.inertia);
    engine.start(fresh);
    EXPECT_EQ(engine.motion().momentum, fresh.momentum);
    EXPECT_EQ(engine.body.ledger().byOthers, 0);
    EXPECT_EQ(engine.body.ledger().start, engine.energy());
}

/// The torques that hold it are nobody's doing.
TEST(BodyMotion, OfABodyThatDoesNotTurnFreelyKeepsItsSpin) {
    Random random(11);
    Engine engine(randomInertia(random), nothing, dt);
    engine.inertia.turnsFreely = false;
    engine.inertia.angularFactor = {0, 0, 1};
    Motion start;
    start.setSpin(engine.inertia, {0, 0, 2});
    engine.start(start);
    engine.steps(60);  // a second
    EXPECT_TRUE(isNear(engine.motion().spin, start.spin, 60 * rounding));
    EXPECT_TRUE(isNear(rotationVector(engine.pose().orientation), Vec3(0, 0, 2), 60 * rounding));
}

TEST(BodyMotion, AtEaseTakesOneEvaluationAStep) {
    const Spring spring(50);
    for (double looksAhead : {0.0, 1e6}) {
        Engine engine(ofBall(2, 0.5), spring, dt, looksAhead);
        engine.start(stillAt(1));
        for (int i = 0; i < 100; ++i) {
            const int onTheWay = engine.body.evaluations();
            engine.depart();
            const int ahead = engine.body.evaluations() - onTheWay;
            engine.body.arrive();
            engine.settle();
            EXPECT_EQ(ahead + engine.body.evaluations(), 1);
        }
    }
}

/// v(n + 1/2) = v(n - 1/2) + dt a(x(n)): what a single impulse a step makes of it.
TEST(BodyMotion, AsPublishedIsAPlainKickAStep) {
    const Spring spring(50);
    Engine engine(ofBall(2, 0.5), spring, dt);
    engine.def.scheme = StepScheme::published;
    Motion start = stillAt(1);
    start.velocity.z() = 3;
    engine.start(start);
    double x = 1, v = 3 - dt / 2 * 25 * x;
    for (int i = 0; i < 1000; ++i) {
        engine.depart();
        EXPECT_NEAR(engine.body.departure().velocity.z(), v, 1000 * rounding);
        engine.body.arrive();
        engine.settle();
        x += dt * v;
        v -= dt * 25 * x;
    }
}

TEST(BodyMotion, AsPublishedGainsTheEnergyThatAFastSpinMakes) {
    for (StepScheme scheme : {StepScheme::published, StepScheme::guarded}) {
        Engine engine(withInertia(1, {1, 2, 2.5}), nothing, dt);
        engine.def.scheme = scheme;
        Motion start;
        start.setSpin(engine.inertia, {1, 5, 1});
        engine.start(start);
        const double before = engine.energy();
        engine.steps(600);
        const double gain = engine.energy() / before - 1;
        if (scheme == StepScheme::published)
            EXPECT_GT(gain, 0.01);
        else
            EXPECT_NEAR(gain, 0, 600 * rounding);
        EXPECT_TRUE(isNear(engine.motion().momentum, start.momentum, 600 * rounding * 10));
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
