#include <gtest/gtest.h>

#include <cstring>

#include "bullet_buoyancy/core/fill_rows.h"
#include "bullet_buoyancy/motion/body_motion.h"
#include "bullet_buoyancy/motion/calm_limits.h"
#include "bullet_buoyancy/motion/rest.h"
#include "support/instruction_sets.h"
#include "support/known_bodies.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double dt = 1.0 / 60, gravity = standardGravity;

/// What acts wherever the body is.
struct GivenLoad final : LoadField {
    Load load;

    Vec3 up() const override { return Vec3::UnitZ(); }
    bool isCalm() const override { return true; }
    Load at(const Pose&, Mat6*) const override { return load; }
};

Load randomLoad(Random& random, const Inertia& inertia) {
    Load load;
    load.force = inertia.mass * random.inCube(gravity);
    load.torque = inertia.mass * random.inCube(0.1);
    load.potential = random.uniform(-1, 1) * inertia.mass;
    load.dragRate = random.coin() ? random.uniform(0, 10) : 0;
    load.dampingRate = random.coin() ? random.uniform(0, 10) : 0;
    return load;
}

/// One of a block, under way.
struct Flier {
    Inertia inertia;
    StepperDef def;
    GivenLoad field;
    BodyMotion body;

    /// Loses potential on the way, so that there is no surplus, but for one in ten.
    explicit Flier(Random& random) : inertia(randomInertia(random)) {
        Motion motion;
        motion.pose = {random.inCube(10), random.orientation()};
        motion.velocity = random.inCube(1);
        motion.setSpin(inertia, random.inCube(random.uniform(0, 2)));
        field.load = randomLoad(random, inertia);
        const double most = field.load.potential;
        body.start(motion);
        body.settle(inertia, def, field, dt);
        body.depart(inertia, def, field, dt);
        field.load = randomLoad(random, inertia);
        field.load.potential = most + inertia.mass * (random.index(10) ? -100 : 100);
    }

    void step() {
        body.arrive();
        body.settle(inertia, def, field, dt);
        body.depart(inertia, def, field, dt);
    }
};

void put(const Load& load, LoadRows& rows, int lane) {
    bullet_buoyancy::put(load.force, rows.force, lane);
    bullet_buoyancy::put(load.torque, rows.torque, lane);
    bullet_buoyancy::put(load.centreFromCom, rows.centreFromCom, lane);
    rows.potential.lane[lane] = load.potential;
    rows.potentialRounding.lane[lane] = load.potentialRounding;
    rows.dragRate.lane[lane] = load.dragRate;
    rows.dampingRate.lane[lane] = load.dampingRate;
    rows.displacement.lane[lane] = load.displacement;
    rows.forceErrorBound.lane[lane] = load.forceErrorBound;
}

struct Block {
    std::vector<Flier> fliers;
    ArrivalRows arrivals{};
    LoadRows loads{};

    explicit Block(Random& random) {
        for (int lane = 0; lane < blockSize; ++lane) {
            const Flier& flier = fliers.emplace_back(random);
            flier.body.put(flier.inertia, arrivals, lane);
            arrivals.length.lane[lane] = random.uniform(0.1, 10);
            put(flier.field.load, loads, lane);
        }
    }

    CalmStepRows steps(InstructionSet set = bestInstructionSet()) const {
        CalmStepRows rows{};
        calmStepKernels(set).step(arrivals, loads, gravity, dt, rows);
        return rows;
    }
};

void expectNear(const Motion& a, const Motion& b, const Inertia& inertia) {
    constexpr double rounding = 32 * epsilon;  // some ten operations on the way, each of numbers of that size
    EXPECT_TRUE(isNear(a.pose.position, b.pose.position, rounding * 10));
    EXPECT_TRUE(isNear(a.pose.orientation.coeffs(), b.pose.orientation.coeffs(), rounding));
    EXPECT_TRUE(isNear(a.velocity, b.velocity, rounding));
    EXPECT_TRUE(isNear(a.momentum, b.momentum, rounding * inertia.principal.maxCoeff()));
    EXPECT_TRUE(
        isNear(a.spin, b.spin, rounding * inertia.principal.maxCoeff() / inertia.principal.minCoeff()));
}

void expectNear(const Flier& lane, const Flier& law) {
    expectNear(lane.body.motion(), law.body.motion(), law.inertia);
    expectNear(lane.body.departure(), law.body.departure(), law.inertia);
    EXPECT_TRUE(isNear(lane.body.target().position, law.body.target().position, 320 * epsilon));
    EXPECT_TRUE(isNear(lane.body.target().orientation.coeffs(), law.body.target().orientation.coeffs(),
                       32 * epsilon));
    // Of what cancels in them: works and energies of a body of up to 10 kg at some 1 m/s.
    constexpr double energies = 64 * epsilon * 10;
    const EnergyLedger &a = lane.body.ledger(), &b = law.body.ledger();
    EXPECT_NEAR(a.toDrag, b.toDrag, energies);
    EXPECT_NEAR(a.toDamping, b.toDamping, energies);
    EXPECT_NEAR(a.expected(), b.expected(), energies + 16 * epsilon * std::abs(b.start));
    EXPECT_EQ(lane.body.evaluations(), law.body.evaluations());
}

/// Twice in a row: what the first step leaves is what the second needs.
TEST(CalmStep, IsThatOfTheLaw) {
    Random random(1);
    int calm = 0;
    constexpr int blocks = 1000;
    for (int i = 0; i < blocks; ++i) {
        const Block block(random);
        const CalmStepRows steps = block.steps();
        for (int lane = 0; lane < blockSize; ++lane) {
            if (!(steps.isCalm.lane[lane] > 0)) continue;
            ++calm;
            Flier byKernel = block.fliers[std::size_t(lane)], byLaw = byKernel;
            ASSERT_TRUE(byKernel.body.isAtEase(byKernel.def, dt));
            byKernel.body.stepCalmly(steps, block.loads, lane);
            byLaw.step();
            expectNear(byKernel, byLaw);
            EXPECT_TRUE(byKernel.body.isAtEase(byKernel.def, dt));
            byKernel.field.load.potential -= 100 * byLaw.inertia.mass;
            byLaw.field.load = byKernel.field.load;
            byKernel.step();
            byLaw.step();
            expectNear(byKernel, byLaw);
        }
    }
    EXPECT_GT(calm, blocks * blockSize / 3);
}

/// Others are left to the law.
TEST(CalmStep, IsForGentleTurnsWithinTheEnergyThatIsThere) {
    Random random(2);
    int lively = 0, inSurplus = 0;
    for (int i = 0; i < 300; ++i) {
        const Block block(random);
        const CalmStepRows steps = block.steps();
        for (int lane = 0; lane < blockSize; ++lane) {
            Flier flier = block.fliers[std::size_t(lane)];
            const double most = flier.body.ledger().start;
            flier.step();
            const bool isGentle = flier.body.departure().spin.norm() * dt < gentleTurn;
            const bool fits = flier.field.load.potential < most;
            const double fastest = std::max(flier.field.load.dragRate, flier.field.load.dampingRate);
            EXPECT_EQ(steps.isCalm.lane[lane] > 0, isGentle && fits && fastest * dt / 2 < dampingSeriesEnds);
            lively += !isGentle;
            inSurplus += !fits;
        }
    }
    EXPECT_GT(lively, 100);
    EXPECT_GT(inSurplus, 100);
}

TEST(CalmStep, LeavesWhatIsNotFiniteToTheLaw) {
    Random random(3);
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Block block(random);
        block.loads.force.y.lane[1] = bad;
        block.loads.torque.x.lane[2] = bad;
        block.loads.dragRate.lane[3] = bad;
        block.arrivals.moving.velocity.z.lane[4] = bad;
        block.arrivals.pose.orientation.w.lane[5] = bad;
        const CalmStepRows steps = block.steps();
        for (int lane = 1; lane <= 5; ++lane)
            EXPECT_FALSE(steps.isCalm.lane[lane] > 0) << lane;
    }
}

TEST(CalmStep, TellsRest) {
    Random random(4);
    int resting = 0;
    for (int i = 0; i < 1000; ++i) {
        Block block(random);
        for (int lane = 0; lane < blockSize; ++lane) {  // so still and balanced that some may pass
            const double share = random.uniform(0, 3e-4);
            bullet_buoyancy::put(share * get(block.loads.force, lane), block.loads.force, lane);
            bullet_buoyancy::put(share * get(block.loads.torque, lane), block.loads.torque, lane);
            for (VectorRows* rows : {&block.arrivals.moving.velocity, &block.arrivals.moving.momentum,
                                     &block.arrivals.moving.spin})
                bullet_buoyancy::put(random.uniform(0, 0.02) * get(*rows, lane), *rows, lane);
        }
        const CalmStepRows steps = block.steps();
        for (int lane = 0; lane < blockSize; ++lane) {
            const Inertia& inertia = block.fliers[std::size_t(lane)].inertia;
            const double length = block.arrivals.length.lane[lane];
            Motion motion;
            motion.velocity = get(steps.settled.velocity, lane);
            motion.momentum = get(steps.settled.momentum, lane);
            motion.spin = get(steps.settled.spin, lane);
            const Unrest unrest{std::sqrt(2 * kineticEnergy(motion, inertia) / inertia.mass),
                                get(block.loads.force, lane).norm() / inertia.mass,
                                get(block.loads.torque, lane).norm() / (inertia.mass * length)};
            EXPECT_EQ(steps.isAtRest.lane[lane] > 0, isAtRest(unrest, gravity, length));
            resting += steps.isAtRest.lane[lane] > 0;
        }
    }
    EXPECT_GT(resting, 100);
    EXPECT_LT(resting, 1000 * blockSize - 100);
}

TEST(CalmStep, IsTheSameToTheLastBitFromAllSets) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const Block block(random);
        const CalmStepRows portable = block.steps(InstructionSet::portable);
        for (InstructionSet set : setsOfThisMachine()) {
            const CalmStepRows steps = block.steps(set);
            EXPECT_EQ(std::memcmp(&steps, &portable, sizeof steps), 0) << nameOf(set);
        }
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
