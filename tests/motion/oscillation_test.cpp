#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/engine.h"
#include "support/near.h"
#include "support/simple_loads.h"

/// What steps make of oscillations whose motion is known.
namespace bullet_buoyancy::test {
namespace {

constexpr double dt = 1.0 / 60;
constexpr double newton = 1e-3;

/// A ball on a spring against heave, with a given phase (rad) a step.
struct Oscillation {
    double omega;
    Inertia ball = ofBall(2, 0.5);
    Spring spring;
    Engine engine;

    explicit Oscillation(double phase)
        : omega(phase / dt), spring(ball.mass * omega * omega), engine(ball, spring, dt, omega * omega) {}
    Oscillation(const Oscillation&) = delete;
};

/// Of the leapfrog: sin(phase' / 2) = phase / 2, which is a period short by phase^2 / 24.
TEST(Oscillation, IsThatOfTheLeapfrogWhereStepsAreSmall) {
    for (double phase : {0.01, 0.1, 0.19}) {
        Oscillation it(phase);
        it.engine.start(stillAt(1));
        const double stepped = 2 * std::asin(phase / 2);
        EXPECT_NEAR((stepped / phase - 1) / (phase * phase / 24), 1, phase * phase);
        constexpr int steps = 10000;
        for (int i = 1; i <= steps; ++i) {
            it.engine.step();
            ASSERT_NEAR(it.engine.height(), std::cos(i * stepped), i * 1e-12) << phase << ' ' << i;
            ASSERT_EQ(it.engine.body.evaluations(), 1);
        }
    }
}

/// Down to six steps a period: tan(phase' / 2) = phase / 2, to what Newton's method leaves of the velocity.
TEST(Oscillation, IsThatOfTheTrapezoidalRuleWhereTheyAreNot) {
    for (double phase : {0.3, 0.6, 0.95}) {
        Oscillation it(phase);
        it.engine.start(stillAt(1));
        const double stepped = 2 * std::atan(phase / 2);
        for (int i = 1; i <= 100; ++i) {
            it.engine.step();
            ASSERT_NEAR(it.engine.height(), std::cos(i * stepped), newton) << phase << ' ' << i;
        }
    }
}

double amplitude(const Oscillation& it) {
    const double speed = it.engine.motion().velocity.z() / it.omega;
    return std::hypot(it.engine.height(), speed);
}

/// The energy of the leapfrog at a pose differs by up to phase^2 / 4 of it.
TEST(Oscillation, KeepsItsAmplitudeFor100000Steps) {
    for (double phase : {0.03, 0.19, 0.24})
        for (bool fromRest : {true, false}) {
            Oscillation it(phase);
            Motion start = stillAt(fromRest ? 1 : 0);
            start.velocity.z() = fromRest ? 0 : it.omega;
            it.engine.start(start);
            it.engine.steps(100000);
            EXPECT_NEAR(amplitude(it), 1, phase * phase / 8 + 1e-9) << phase << ' ' << fromRest;
        }
}

/// Beyond three steps a period there is nothing left to keep.
TEST(Oscillation, DiesAtItsRestWhereItIsFasterThanTheSteps) {
    for (double phase : {3.0, 10.0, 50.0}) {
        Oscillation it(phase);
        it.engine.start(stillAt(1));
        it.engine.steps(100);
        EXPECT_LT(amplitude(it), 1e-3) << phase;
    }
}

TEST(Oscillation, NeverHasMoreThanTheEnergyOfItsStart) {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const double phase = std::pow(10, random.uniform(-2, 2));
        Oscillation it(phase);
        Motion start = stillAt(random.uniform(-1, 1));
        start.velocity.z() = it.omega * random.uniform(-1, 1);
        it.engine.start(start);
        const double energy = it.engine.energy();
        for (int step = 0; step < 300; ++step) {
            it.engine.step();
            ASSERT_LE(it.engine.energy(), energy * (1 + 1e-3)) << phase << ' ' << step;
        }
    }
}

/// Without restoring torque a body falls over as its growth rate says.
TEST(Oscillation, ThatIsNoneIsNotFrozen) {
    for (double stiffest : {0.0, 1e2, 1e6}) {  // whether it looks ahead or not
        const double rate = 2;
        Mat6 stiffness = Mat6::Zero();
        const Inertia inertia = withInertia(1, {1, 2, 3});
        stiffness(3, 3) = -rate * rate * inertia.principal.x();
        const Spring topHeavy(stiffness);
        Engine engine(inertia, topHeavy, dt, stiffest);
        const double tilt = 1e-5;
        Motion start;
        start.pose.orientation = Eigen::AngleAxisd(tilt, Vec3::UnitX());
        engine.start(start);
        const double seconds = 4;
        engine.steps(int(std::lround(seconds / dt)));
        const double fallen = rotationVector(engine.pose().orientation).x();
        // The leapfrog's rate errs by a share of (rate dt)^2 / 24; what it has of energy beyond that of the
        // start, by (rate dt)^2 / 4 of the motion, is taken: together less than the square itself.
        const double measured = std::acosh(fallen / tilt) / seconds;
        EXPECT_NEAR(measured / rate, 1, rate * rate * dt * dt) << stiffest;
    }
}

/// The same by columns under its corners that are stiff enough in heave for it to look ahead in every step.
TEST(Oscillation, OfATopHeavyBodyOnColumnsIsAFall) {
    const double mass = 10, lift = 1000, height = 0.5, halfWidth = 0.05, weight = 9.8 * mass;
    const double a = halfWidth;
    const Columns columns({{a, a, -height}, {-a, a, -height}, {a, -a, -height}, {-a, -a, -height}}, lift,
                          weight);
    const Inertia inertia = withInertia(mass, {10, 10, 1});
    const double rate = std::sqrt((weight * height - 4 * lift * a * a) / inertia.principal.x());
    Engine engine(inertia, columns, dt, 4 * lift / mass);
    const double tilt = 1e-5;
    Motion start = stillAt(height - weight / (4 * lift));
    start.pose.orientation = Eigen::AngleAxisd(tilt, Vec3::UnitX());
    engine.start(start);
    int lookedAhead = 0;
    for (int i = 0; i < 240; ++i) {
        engine.step();
        lookedAhead += engine.body.evaluations() == 0;
    }
    EXPECT_EQ(lookedAhead, 240);  // nothing was left to evaluate on arrival
    const double measured = std::acosh(rotationVector(engine.pose().orientation).x() / tilt) / 4;
    EXPECT_NEAR(measured / rate, 1, rate * rate * dt * dt);
}

}  // namespace
}  // namespace bullet_buoyancy::test
