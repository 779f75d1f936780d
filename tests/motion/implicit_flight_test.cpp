#include "bullet_buoyancy/motion/implicit_flight.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "bullet_buoyancy/motion/energy_guard.h"
#include "support/known_bodies.h"
#include "support/near.h"
#include "support/simple_loads.h"

namespace bullet_buoyancy::test {
namespace {

/// The share of the velocities that Newton's method may leave: eight steps, of which each may be cut to one
/// that does half of the way.
constexpr double newton = 1.0 / 256;
constexpr double ofPotential = 1e-10;  // likewise of the potential, as a kinetic energy

FlightStart startOf(const Motion& motion, const LoadField& field) {
    FlightStart start{motion, {}, Mat6::Zero(), largestTurn};
    start.load = field.at(motion.pose, &start.stiffness);
    return start;
}

/// A whole step, with the kick that ends it.
Motion step(const Motion& motion, const Inertia& inertia, double implicitness, double dt,
            const LoadField& field, int* evaluations = nullptr) {
    const FlightStart start = startOf(motion, field);
    const Flight flight = flyImplicitly(start, inertia, implicitness, dt, field);
    if (evaluations) *evaluations = flight.evaluations;
    const KickWeights weights(implicitness);
    Motion end = flight.arrival;
    Kick(flight.load, dt)
        .apply(end, inertia, weights.lastOfStart * start.load.force + weights.lastOfEnd * flight.load.force,
               weights.lastOfStart * start.load.torque + weights.lastOfEnd * flight.load.torque);
    return end;
}

double energyOf(const Motion& motion, const Inertia& inertia, const LoadField& field) {
    return totalEnergy(motion, inertia, field.at(motion.pose));
}

/// Against heave, and turning about the horizontal, all of it coupled.
Mat6 randomStiffness(Random& random) {
    Mat3 root;
    for (double& value : root.reshaped())
        value = random.uniform(-1, 1);
    Mat6 stiffness = Mat6::Zero();
    stiffness.block<3, 3>(2, 2) = root * root.transpose() + 0.1 * Mat3::Identity();
    return stiffness;
}

Mat6 massMatrix(const Inertia& inertia, const Pose& pose) {
    Mat6 mass = Mat6::Zero();
    mass.topLeftCorner<3, 3>() = inertia.mass * Mat3::Identity();
    for (int i = 0; i < 3; ++i)
        mass.block<3, 1>(3, 3 + i) = inertia.momentum(pose.orientation, Vec3::Unit(i));
    return mass;
}

/// In turns so small that a step is a linear map.
struct LinearCase {
    static constexpr double small = 1e-7;
    Inertia inertia;
    Motion motion;
    Mat6 stiffness;
    double dt;
    Vec6 position, velocity;

    explicit LinearCase(Random& random)
        : inertia(randomInertia(random)),
          stiffness(std::pow(10, random.uniform(-2, 5)) * randomStiffness(random)),
          dt(std::pow(10, random.uniform(-3, 0))) {
        motion.pose.position = small * random.inCube(1);
        motion.velocity = small / dt * random.inCube(1);
        motion.setSpin(inertia, small / dt * random.inCube(1));
        position << motion.pose.position, 0, 0, 0;
        velocity << motion.velocity, motion.spin;
    }

    Mat6 mass() const { return massMatrix(inertia, motion.pose); }
    /// What may be left of a difference to the solution, kg^(1/2) m/s.
    double tolerance(const Vec6& solution, const Spring& spring, const Pose& end) const {
        const double inMotion = std::max(size(solution), size(velocity));
        return newton * inMotion + std::sqrt(ofPotential * spring.at(end, nullptr).potential);
    }
    double size(const Vec6& difference) const { return std::sqrt(difference.dot(mass() * difference)); }
    Vec6 solved(const Mat6& matrix, const Vec6& right) const { return matrix.partialPivLu().solve(right); }
};

TEST(KickWeights, OfTwoKicksAddToOneStep) {
    for (double implicitness : {0.0, 0.3, 1.0}) {
        const KickWeights weights(implicitness);
        const double first = weights.firstOfStart + weights.firstOfEnd;
        const double last = weights.lastOfStart + weights.lastOfEnd;
        EXPECT_DOUBLE_EQ(first + last, 2);
        EXPECT_DOUBLE_EQ(first, 1 + implicitness);
    }
}

/// u = (M + dt^2 K)^-1 (M v - dt K x). What is not linear in turns of 1e-7 rad is a few 1e-7 of them.
TEST(ImplicitFlight, ByEulerIsTheSolutionOfTheLinearSystem) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const LinearCase body(random);
        const Spring spring(body.stiffness);
        const Flight flight = flyImplicitly(startOf(body.motion, spring), body.inertia, 1, body.dt, spring);
        const Mat6 matrix = body.mass() + body.dt * body.dt * body.stiffness;
        const Vec6 right = body.mass() * body.velocity - body.dt * body.stiffness * body.position;
        const Vec6 u = body.solved(matrix, right);
        Vec6 result;
        result << flight.departure.velocity, flight.departure.spin;
        EXPECT_LE(body.size(result - u), body.tolerance(u, spring, flight.arrival.pose)) << i;
    }
}

/// v' = v + dt (a + a') / 2 and x' = x + dt (v + v') / 2.
TEST(ImplicitFlight, ByTheTrapezoidalRuleIsTheSolutionOfTheLinearSystem) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const LinearCase body(random);
        const Spring spring(body.stiffness);
        const Motion end = step(body.motion, body.inertia, 0, body.dt, spring);
        const Mat6 quarter = body.dt * body.dt / 4 * body.stiffness;
        const Vec6 right = (body.mass() - quarter) * body.velocity - body.dt * body.stiffness * body.position;
        const Vec6 expected = body.solved(body.mass() + quarter, right);
        Vec6 result;
        result << end.velocity, end.spin;
        EXPECT_LE(body.size(result - expected), body.tolerance(expected, spring, end.pose)) << i;
    }
}

double phaseOf(Random& random) {
    return std::pow(10, random.uniform(-1, 1.7));  // omega dt
}

TEST(ImplicitFlight, ByTheTrapezoidalRuleKeepsTheEnergyOfALinearOscillationAtAnyStep) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double dt = 0.02, phase = phaseOf(random), omega = phase / dt;
        const Inertia ball = ofBall(2, 0.5);
        const Spring spring(ball.mass * omega * omega);
        Motion motion = stillAt(random.uniform(-1, 1));
        motion.velocity = omega * random.inCube(1);
        const double energy = energyOf(motion, ball, spring);
        EXPECT_NEAR(energyOf(step(motion, ball, 0, dt, spring), ball, spring) / energy, 1, newton) << phase;
    }
}

/// From the spring's middle, v' = v / (1 + phase^2).
TEST(ImplicitFlight, ByEulerTakesWhatIsFasterThanTheStep) {
    const double dt = 0.02;
    const Inertia ball = ofBall(2, 0.5);
    for (double phase : {0.1, 1.0, 10.0, 50.0}) {
        const Spring spring(ball.mass * phase * phase / (dt * dt));
        Motion motion;
        motion.velocity = {1, 2, 3};
        const Motion end = step(motion, ball, 1, dt, spring);
        EXPECT_EQ(end.velocity.head<2>(), motion.velocity.head<2>());
        EXPECT_NEAR(end.velocity.z(), 3 / (1 + phase * phase), 3 * newton) << phase;
    }
}

/// Above which the potential of a body cannot be, if it isn't already: that of its start, and what moves it
/// up.
TEST(ImplicitFlight, ByEulerEndsNoHigherThanTheEnergyOfItsStart) {
    Random random(4);
    for (int i = 0; i < 10000; ++i) {
        const double mass = std::pow(10, random.uniform(-4, 0));
        const double dt = std::pow(10, random.uniform(std::log10(1.0 / 240), -1));
        const Columns column({Vec3::Zero()}, std::pow(10, random.uniform(0, 4)), 9.8 * mass);
        const Inertia ball = ofBall(mass, 0.1);
        Motion motion = stillAt(random.uniform(-0.5, 0.5));
        motion.velocity = random.inCube(std::pow(10, random.uniform(-2, 2)));
        const FlightStart start = startOf(motion, column);
        const double upward = motion.velocity.z(),
                     available = start.load.potential + mass * upward * upward / 2;
        const Flight flight = flyImplicitly(start, ball, 1, dt, column);
        EXPECT_LE(flight.load.potential, available + 1e-9 * std::abs(start.load.potential))
            << "mass " << mass << ", dt " << dt;
    }
}

/// The stiffness at the start says nothing about the end.
TEST(ImplicitFlight, ByEulerGainsNothingInAStiffPit) {
    Random random(5);
    for (int i = 0; i < 10000; ++i) {
        const double mass = std::pow(10, random.uniform(-4, 0)), dt = 1.0 / 60;
        const Pit pit(std::pow(10, random.uniform(0, 5)), 0.1);
        const Inertia ball = ofBall(mass, 0.1);
        Motion motion = stillAt(random.uniform(-0.3, 0.3));
        motion.velocity.z() = random.uniform(-30, 30);
        const FlightStart start = startOf(motion, pit);
        const Flight flight = flyImplicitly(start, ball, 1, dt, pit);
        EXPECT_LE(flight.load.potential,
                  totalEnergy(motion, ball, start.load) + 1e-9 * std::abs(start.load.potential));
    }
}

TEST(ImplicitFlight, KnowsTheLoadWhereItEnds) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Columns raft(cornersOfBox({0.5, 0.3, 0.1}), 1000, 100);
        const Inertia box = ofBox(10, {0.5, 0.3, 0.1});
        Motion motion = randomMotion(random, box);
        motion.pose.position.z() *= 0.1;
        const double dt = 0.05, implicitness = random.uniform(0, 1);
        const Flight flight = flyImplicitly(startOf(motion, raft), box, implicitness, dt, raft);
        const Load load = raft.at(flight.arrival.pose, nullptr);
        EXPECT_EQ(flight.load.force, load.force);
        EXPECT_EQ(flight.load.torque, load.torque);
        EXPECT_EQ(flight.load.potential, load.potential);
        EXPECT_TRUE(isNear(flight.arrival.pose.position,
                           motion.pose.position + dt * flight.departure.velocity, 10 * epsilon));
        EXPECT_TRUE(isNear(flight.arrival.momentum, flight.departure.momentum, 0));
    }
}

/// Half of them at most four times: the linear system, and a look or two on the way there.
TEST(ImplicitFlight, TakesFewEvaluationsOfALinearLoad) {
    Random random(7);
    for (double implicitness : {0.0, 0.5, 1.0}) {
        std::vector<int> counts;
        for (int i = 0; i < 1001; ++i) {
            const LinearCase body(random);
            const Spring spring(body.stiffness);
            counts.push_back(0);
            step(body.motion, body.inertia, implicitness, body.dt, spring, &counts.back());
            EXPECT_GE(counts.back(), 1);
        }
        std::sort(counts.begin(), counts.end());
        EXPECT_LE(counts[500], 4) << implicitness << ", at most " << counts.back();
    }
}

/// Falling at it with the weight for a load. The rule of Euler puts the load before the drag: off by a share
/// of half of the drag in half a step.
TEST(ImplicitFlight, InAMediumKeepsTheTerminalVelocity) {
    const Inertia ball = ofBall(2, 0.5);
    const double dt = 0.05;
    for (double rate : {0.1, 1.0, 3.0})
        for (double implicitness : {0.0, 0.5, 1.0}) {
            Weight weight(20);
            weight.medium.dragRate = rate;
            weight.medium.velocity = {1, 0, 0};
            Motion motion;
            motion.velocity = {1, 0, -10 / rate};
            const Motion end = step(motion, ball, implicitness, dt, weight);
            const double tolerance = newton + implicitness * rate * dt / 4;
            EXPECT_NEAR(end.velocity.z() / motion.velocity.z(), 1, tolerance) << rate << ' ' << implicitness;
            EXPECT_NEAR(end.velocity.x(), 1, 10 * epsilon);
        }
}

}  // namespace
}  // namespace bullet_buoyancy::test
