#include "bullet_buoyancy/motion/energy_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/known_bodies.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double rounding = 100 * epsilon;
const Vec3 up = Vec3::UnitZ();

/// A body on the move under a load along `up`, which may be too much for it.
struct Case {
    Inertia inertia;
    Motion motion;
    Load load;

    explicit Case(Random& random) : inertia(randomInertia(random)), motion(randomMotion(random, inertia)) {
        load.force.z() = random.uniform(-100, 100);
        load.torque = random.inCube(100);
        load.torque.z() = 0;
        load.potential = random.uniform(-100, 100);
    }

    double energy() const { return totalEnergy(motion, inertia, load); }
    double least() const { return load.potential + keptEnergy(motion, inertia, up); }
    double scale() const { return kineticEnergy(motion, inertia) + std::abs(load.potential); }
    void limit(double available, bool strict = false) {
        limitEnergy(motion, inertia, load, {available, up, strict});
    }
};

void expectKept(const Motion& before, const Motion& after) {
    EXPECT_EQ(after.velocity.head<2>(), before.velocity.head<2>());
    EXPECT_NEAR(after.momentum.z(), before.momentum.z(), rounding * before.momentum.norm());
    EXPECT_EQ(after.pose.position, before.pose.position);
    EXPECT_EQ(after.pose.orientation.coeffs(), before.pose.orientation.coeffs());
}

TEST(KeptEnergy, IsOfTheMotionAcrossUpAndOfTheSpinAboutIt) {
    const Inertia inertia = withInertia(2, {1, 2, 3});
    Motion motion;
    motion.velocity = {3, 4, 5};
    motion.setSpin(inertia, {1, 1, 2});
    EXPECT_DOUBLE_EQ(keptEnergy(motion, inertia, up), 25 + 6);
    EXPECT_DOUBLE_EQ(keptEnergy(motion, inertia, Vec3::UnitX()), 16 + 25 + 0.5);
}

TEST(EnergyGuard, LeavesAMotionThatHasNoSurplus) {
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        Case body(random);
        const Motion before = body.motion;
        body.limit(body.energy(), i % 2 == 0);
        body.limit(body.energy() + random.uniform(0, 100), i % 2 == 0);
        EXPECT_EQ(body.motion.velocity, before.velocity);
        EXPECT_EQ(body.motion.momentum, before.momentum);
        EXPECT_EQ(body.motion.spin, before.spin);
    }
}

/// Up to what it takes for rounding.
TEST(EnergyGuard, LeavesAsMuchAsIsAvailableWhereItCan) {
    Random random(2);
    for (int i = 0; i < 10000; ++i) {
        Case body(random);
        const Motion before = body.motion;
        const double energy = body.energy(), available = random.uniform(body.least(), energy);
        body.limit(available, i % 2 == 0);
        EXPECT_NEAR(body.energy(), available,
                    1e-9 * (energy - available) + (rounding + 1e-12) * body.scale());
        expectKept(before, body.motion);
    }
}

/// By one impulse, so many times its force and its torque.
TEST(EnergyGuard, BrakesAlongTheLoad) {
    Random random(3);
    Case body(random);
    const Motion before = body.motion;
    body.limit(body.energy() - 1e-3 * kineticEnergy(before, body.inertia));
    const Vec3 impulse = body.inertia.mass * (body.motion.velocity - before.velocity);
    const Vec3 angularImpulse = body.motion.momentum - before.momentum;
    const double share = impulse.dot(body.load.force) / body.load.force.squaredNorm();
    EXPECT_TRUE(isNear(impulse, share * body.load.force, rounding * before.velocity.norm() * 10));
    EXPECT_TRUE(isNear(angularImpulse, share * body.load.torque, rounding * before.momentum.norm() * 10));
    EXPECT_NE(share, 0);
}

TEST(EnergyGuard, StopsWhatMayBeStoppedWhereThePoseHoldsTooMuch) {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        Case body(random);
        const Motion before = body.motion;
        const double kept = keptEnergy(before, body.inertia, up);
        body.limit(body.load.potential - random.uniform(0, 100));
        EXPECT_LE(kineticEnergy(body.motion, body.inertia), kept + rounding * body.scale());
        expectKept(before, body.motion);
    }
}

TEST(EnergyGuard, StopsABallAltogetherUpwardAndAboutTheHorizontal) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        Case body(random);
        body.inertia = ofBall(3, 0.5);
        body.motion.setMomentum(body.inertia, body.motion.momentum);
        const Motion before = body.motion;
        body.limit(body.load.potential - 1);
        const double size = before.velocity.norm() + before.momentum.norm();
        EXPECT_NEAR(body.motion.velocity.z(), 0, rounding * size);
        EXPECT_TRUE(isNear(body.motion.momentum, Vec3(0, 0, before.momentum.z()), rounding * size));
        expectKept(before, body.motion);
    }
}

TEST(EnergyGuard, NeverAddsEnergy) {
    Random random(6);
    for (int i = 0; i < 10000; ++i) {
        Case body(random);
        if (random.coin()) body.inertia.turnsFreely = false;
        const double before = body.energy();
        body.limit(before - std::pow(10, random.uniform(-12, 3)), random.coin());
        EXPECT_LE(body.energy(), before + rounding * body.scale());
    }
}

TEST(EnergyGuard, OfAStrictLimitTakesTheSpinAboutTheVerticalToo) {
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        Case body(random);
        body.motion.velocity.z() = body.load.force.z() = 0;
        const double mass = body.inertia.mass;
        const double level = mass * body.motion.velocity.head<2>().squaredNorm() / 2;
        const double floor = body.load.potential + level;
        const double available = random.uniform(floor, std::min(body.least(), body.energy()));
        body.limit(available, true);
        // What is below a share of 1e-4 of the motion is no sign of a turn too large, and left.
        EXPECT_LE(body.energy(), available + 2e-4 * kineticEnergy(body.motion, body.inertia));
    }
}

TEST(EnergyGuard, OfAStrictLimitKeepsTheVelocityAlongTheSurface) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        Case body(random);
        const Motion before = body.motion;
        body.limit(body.load.potential - 10, true);
        EXPECT_EQ(body.motion.velocity.head<2>(), before.velocity.head<2>());
        EXPECT_TRUE(isNear(body.motion.spin, Vec3::Zero(), 0));
    }
}

TEST(EnergyGuard, SlowsTheSpinOfABodyThatDoesNotTurnFreelyAboutTheHorizontal) {
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        Case body(random);
        body.inertia.turnsFreely = false;
        body.load.torque.setZero();
        const Vec3 spin = body.motion.spin;
        body.motion.velocity.z() = 0;
        const double energy = body.energy(), available = random.uniform(body.least(), energy);
        body.limit(available);
        EXPECT_NEAR(body.energy(), available, 1e-9 * (energy - available) + 1e-11 * body.scale());
        EXPECT_NEAR(body.motion.spin.z(), spin.z(), rounding * spin.norm());
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
