#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/engine.h"
#include "support/near.h"
#include "support/simple_loads.h"

/// What becomes of a body's energy in steps too long for it, and in those that are not.
namespace bullet_buoyancy::test {
namespace {

constexpr double gravity = 9.8;

/// A box that eight columns carry at its corners, as light, stiff and fast as you like.
struct Raft {
    Vec3 halfSize;
    Inertia inertia;
    Columns field;
    Engine engine;

    /// `lift` of each corner, N/m
    Raft(const Vec3& half, double mass, double lift, double dt)
        : halfSize(half),
          inertia(ofBox(mass, half)),
          field(cornersOfBox(half), lift, gravity * mass),
          engine(inertia, field, dt, fastest(half, inertia, lift)) {
        engine.def.size = half.norm();
    }
    Raft(const Raft&) = delete;

    static double fastest(const Vec3& half, const Inertia& inertia, double lift) {
        const Vec3 squares = half.cwiseAbs2();
        const Vec3 turning = 8 * lift * (Vec3::Constant(squares.sum()) - squares);
        return std::max(8 * lift / inertia.mass, turning.cwiseProduct(inertia.inversePrincipal).maxCoeff());
    }
};

double randomPower(Random& random, double least, double most) {
    return least * std::pow(most / least, random.uniform(0, 1));
}

Vec3 randomHalfSize(Random& random) {
    const double x = random.uniform(0.02, 1), y = random.uniform(0.02, 1);
    return {x, y, random.uniform(0.02, 1)};
}

/// To what the guard lets pass: an explicit step may end as much too high as a thousandth of what moves.
TEST(EnergyOfSteps, NeverIsMoreThanThatOfTheStart) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double mass = randomPower(random, 1e-4, 1), dt = randomPower(random, 1.0 / 240, 0.1);
        Raft raft(randomHalfSize(random), mass, randomPower(random, 1, 1e4), dt);
        Motion start = randomMotion(random, raft.inertia);
        start.velocity *= randomPower(random, 0.01, 10);
        start.setSpin(raft.inertia, start.spin * randomPower(random, 0.01, 10));
        raft.engine.start(start);
        const double before = raft.engine.energy(), scale = before + gravity * mass;
        double most = before;
        for (int step = 0; step < 300; ++step) {
            raft.engine.step();
            most = std::max(most, raft.engine.energy());
        }
        EXPECT_LE(most - before, 1e-3 * scale) << i << ": mass " << mass << ", dt " << dt;
    }
}

/// What a ball keeps of its height: no rebound rises above the drop.
TEST(EnergyOfSteps, LetsNoColumnRiseAboveItsDrop) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const double mass = randomPower(random, 1e-4, 1), dt = randomPower(random, 1.0 / 240, 0.1);
        const double lift = randomPower(random, 1, 1e4), drop = randomPower(random, 0.01, 10);
        const Columns column({Vec3::Zero()}, lift, gravity * mass);
        Engine engine(ofBall(mass, 0.1), column, dt, lift / mass);
        engine.start(stillAt(drop));
        double highest = drop;
        for (int step = 0; step < 1000; ++step) {
            engine.step();
            highest = std::max(highest, engine.height());
        }
        EXPECT_LE(highest, drop * 1.001) << i << ": mass " << mass << ", dt " << dt << ", lift " << lift;
    }
}

TEST(EnergyOfSteps, InAPitIsNoMoreThanThatOfTheStart) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double mass = randomPower(random, 1e-4, 1), spring = randomPower(random, 1, 1e5);
        const Pit pit(spring, 0.1);
        Engine engine(ofBall(mass, 0.1), pit, 1.0 / 60, spring / mass);
        Motion start = stillAt(random.uniform(-0.2, 0.2));
        start.velocity.z() = random.uniform(-10, 10);
        engine.start(start);
        const double before = engine.energy(), depth = spring * 0.01 / 2;
        for (int step = 0; step < 100; ++step) {
            engine.step();
            ASSERT_LE(engine.energy(), before + 1e-3 * (before + depth)) << i << ' ' << step;
        }
    }
}

/// From a step that takes energy on there is no more than it left, however the body moves afterwards.
TEST(EnergyOfSteps, ThatDampIsGoneForGood) {
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const double mass = randomPower(random, 1e-3, 1), dt = 1.0 / 60, phase = random.uniform(2, 20);
        const Columns column({Vec3::Zero()}, mass * phase * phase / (dt * dt), gravity * mass);
        Engine engine(ofBall(mass, 0.1), column, dt, phase * phase / (dt * dt));
        engine.start(stillAt(0.5));
        const double scale = engine.energy();
        double least = scale;
        for (int step = 0; step < 300; ++step) {
            engine.step();
            ASSERT_LE(engine.energy(), least + 1e-3 * scale) << phase << ' ' << step;
            least = std::min(least, engine.energy());
        }
    }
}

/// What the ledger and the body differ by, J, after a second of a damped oscillation in heave and roll.
double unaccounted(double dt) {
    Mat6 stiffness = Mat6::Zero();
    stiffness(2, 2) = 20;
    stiffness(3, 3) = 9;
    stiffness(2, 3) = stiffness(3, 2) = 3;
    Spring spring(stiffness);
    spring.medium.dragRate = 0.8;
    spring.medium.dampingRate = 0.5;
    Engine engine(withInertia(1, {1, 2, 3}), spring, dt);
    Motion start = stillAt(0.3);
    start.pose.orientation = Eigen::AngleAxisd(0.4, Vec3::UnitX());
    engine.start(start);
    engine.steps(int(std::lround(1 / dt)));
    const EnergyLedger& ledger = engine.body.ledger();
    EXPECT_EQ(ledger.byOthers, 0);
    EXPECT_GT(ledger.toDrag, 0);
    EXPECT_GT(ledger.toDamping, 0);
    EXPECT_NEAR(engine.energy(), ledger.start - ledger.toDrag - ledger.toDamping,
                25 * dt * dt * ledger.start);
    return ledger.expected() - engine.energy();
}

/// 25 / s^2 is the square of its fastest oscillation.
TEST(EnergyLedger, ClosesToTheSecondOrderOfTheStep) {
    const double coarse = unaccounted(1.0 / 50), middle = unaccounted(1.0 / 100),
                 fine = unaccounted(1.0 / 200);
    EXPECT_NEAR(coarse / middle, 4, 0.4);
    EXPECT_NEAR(middle / fine, 4, 0.2);
}

/// Of gravity alone, and a drag that it falls against: a step is exact in its forces, and the drag is that of
/// the pose.
TEST(EnergyLedger, ClosesForABodyThatSinks) {
    for (double dt : {0.1, 0.01}) {
        Weight sea(2 * gravity);
        sea.medium.dragRate = 3;
        Engine engine(ofBall(2, 0.1), sea, dt);
        engine.start(stillAt(0));
        engine.steps(int(std::lround(5 / dt)));
        const EnergyLedger& ledger = engine.body.ledger();
        EXPECT_NEAR(engine.motion().velocity.z(), -gravity / 3 * (1 - std::exp(-15)), 1e-12);
        const double sunk = -2 * gravity * engine.height();
        EXPECT_NEAR(ledger.toDrag, sunk - kineticEnergy(engine.motion(), engine.inertia),
                    3 * 3 * dt * dt * sunk);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
