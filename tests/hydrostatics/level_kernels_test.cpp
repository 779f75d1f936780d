#include "bullet_buoyancy/hydrostatics/level_kernels.h"

#include <gtest/gtest.h>

#include <cstring>

#include "bullet_buoyancy/hydrodynamics/calm_load_kernels.h"
#include "bullet_buoyancy/hydrodynamics/wet_rate.h"
#include "bullet_buoyancy/hydrostatics/clip_kernels.h"
#include "bullet_buoyancy/hydrostatics/displace_block.h"
#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "support/instruction_sets.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/random_rows.h"
#include "support/still_water.h"

namespace bullet_buoyancy::test {
namespace {

using Hulls = std::vector<std::shared_ptr<const Hull>>;

const LevelWater level{{0, 0, 1}, {0, 0, 0}, weightDensity};

/// Meshes of one pack, of a few, of many, and with spheres.
Hulls closedHulls() {
    Hulls hulls;
    for (const NamedHull& named : polyhedra())
        hulls.push_back(named.hull);
    hulls.push_back(hullOf(std::vector<HullPart>{Sphere{Vec3(0.1, 0, 0), 0.4}}));
    hulls.push_back(hullOf(std::vector<HullPart>{Sphere{Vec3(0, 0, 2), 0.4}, boxMesh({1, 1, 1})}));
    return hulls;
}

struct Block {
    BlockDisplacement displacement;
    PoseRows poses;
    std::vector<const Hull*> hulls;

    void set(int lane, const Hull& hull, const Pose& pose) {
        displacement.setHull(lane, hull);
        put(pose, poses, lane);
        hulls.push_back(&hull);
    }
};

/// From above the surface to below it.
Pose randomPose(const Hull& hull, Random& random) {
    Pose pose = atSurface(hull, random);
    pose.position += random.inCube(1).cwiseProduct(Vec3(10, 10, random.coin() ? 0 : hull.bounds.radius));
    return pose;
}

Block blockOf(const Hulls& hulls, Random& random) {
    Block block;
    for (int lane = 0; lane < blockSize; ++lane) {
        const Hull& hull = *hulls[random.index(hulls.size())];
        block.set(lane, hull, randomPose(hull, random));
    }
    return block;
}

FloatingRows randomBodies(Random& random) {
    FloatingRows bodies;
    fill(bodies.weight, random, 5000);
    fill(bodies.linearDrag, random, 0, 5);
    fill(bodies.angularDamping, random, 0, 5);
    fill(bodies.airRate, random, 0, 1);
    for (double& scales : bodies.scales.lane)
        scales = random.coin();
    return bodies;
}

LoadRows loadsOf(const Block& block, const FloatingRows& bodies, InstructionSet set = bestInstructionSet()) {
    LoadRows loads{};
    calmLoadKernels(set).load(level, block.poses, block.displacement.hulls(), bodies,
                              block.displacement.rows(), loads);
    return loads;
}

/// To rounding of a few operations on the pressure on all of the hull.
void expectAsEvaluated(const Block& block, const FloatingRows& bodies, const LoadRows& loads, int lane,
                       Precision precision) {
    const Hull& hull = *block.hulls[std::size_t(lane)];
    const Pose pose = poseOf(block.poses, lane);
    HydrostaticQuery query;
    query.precision = precision;
    const HydrostaticResult law = evaluate(hull, pose, stillWater(), query);
    const Vec3 weight = get(bodies.weight, lane);
    // What rounding of the plane in single precision, or in double, makes of depths.
    const double unit = precision == Precision::single ? 2e-7 : epsilon;
    const double size = hull.bounds.centre.norm() + hull.bounds.radius,
                 rounding = 64 * unit * std::pow(size, 3), force = weightDensity * rounding;
    EXPECT_NEAR(loads.displacement.lane[lane], law.submergedVolume, rounding);
    EXPECT_TRUE(isNear(get(loads.force, lane), law.forceWorld + weight, force));
    EXPECT_TRUE(isNear(get(loads.torque, lane), law.torqueAboutCom, size * force));
    EXPECT_TRUE(isNear(law.submergedVolume * get(loads.centreFromCom, lane),
                       law.submergedVolume * law.centreOfBuoyancyFromCom, 2 * size * rounding));
    const double potential = law.potentialEnergy - weight.dot(pose.position);
    EXPECT_NEAR(loads.potential.lane[lane], potential,
                3 * size * force + 4 * epsilon * weight.norm() * pose.position.norm());
    EXPECT_GE(loads.potentialRounding.lane[lane], 16 * epsilon * std::abs(potential) * (1 - 1e-12));
    EXPECT_NEAR(loads.forceErrorBound.lane[lane], law.forceErrorBound, epsilon * law.forceErrorBound);
    const double share = loads.displacement.lane[lane] / hull.moments.volume;
    const bool scales = bodies.scales.lane[lane] > 0;
    EXPECT_NEAR(loads.dragRate.lane[lane],
                wetRate(bodies.linearDrag.lane[lane], share, scales) + bodies.airRate.lane[lane],
                10 * epsilon);
    EXPECT_NEAR(loads.dampingRate.lane[lane], wetRate(bodies.angularDamping.lane[lane], share, scales),
                10 * epsilon);
}

TEST(LevelKernels, MakeTheLoadThatTheEvaluatorDoes) {
    const Hulls hulls = closedHulls();
    Random random(1);
    for (Precision precision : {Precision::full, Precision::single})
        for (int i = 0; i < 300; ++i) {
            Block block = blockOf(hulls, random);
            const FloatingRows bodies = randomBodies(random);
            block.displacement.take(level, block.poses, precision);
            const LoadRows loads = loadsOf(block, bodies);
            for (int lane = 0; lane < blockSize; ++lane)
                expectAsEvaluated(block, bodies, loads, lane, precision);
        }
}

bool isSame(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Bodies of one hull go through another kernel than those of many.
TEST(LevelKernels, DisplaceTheSameToTheLastBitWhateverTheOthersOfABlock) {
    const Hulls hulls = closedHulls();
    Random random(2);
    for (const auto& hull : hulls)
        for (int i = 0; i < 20; ++i) {
            Block alike = blockOf({hull}, random), mixed = blockOf(hulls, random);
            const int place = int(random.index(blockSize));
            mixed.set(place, *hull, poseOf(alike.poses, 3));
            alike.displacement.take(level, alike.poses, Precision::full);
            mixed.displacement.take(level, mixed.poses, Precision::full);
            const DisplacementRows &a = alike.displacement.rows(), &b = mixed.displacement.rows();
            EXPECT_TRUE(isSame(a.volume.lane[3], b.volume.lane[place]));
            EXPECT_TRUE(isSame(a.headVolume.lane[3], b.headVolume.lane[place]));
            EXPECT_EQ(get(a.volumeMoment, 3), get(b.volumeMoment, place));
        }
}

struct Outcome {
    PlaneRows planes{};
    PressureSumRows sums{};
    DisplacementRows displaced{};
    LoadRows loads{};
};

Outcome outcomeOf(InstructionSet set, const Hull& hull, const Block& block, const FloatingRows& bodies) {
    const LevelKernels& kernels = levelKernels(set);
    Outcome outcome;
    kernels.see(level, block.poses, block.displacement.hulls(), outcome.planes);
    kernels.press(hull.packed.full.packs.front(), int(hull.mesh.triangles.size()), outcome.planes,
                  outcome.sums);
    kernels.displace(block.displacement.hulls(), outcome.planes, outcome.sums, outcome.displaced);
    calmLoadKernels(set).load(level, block.poses, block.displacement.hulls(), bodies, outcome.displaced,
                              outcome.loads);
    return outcome;
}

TEST(LevelKernels, AreTheSameToTheLastBitFromAllSets) {
    Random random(3);
    const auto hull = hullOf(boxMesh({1, 0.8, 0.6}, {0.1, 0, 0.2}));
    for (int i = 0; i < 200; ++i) {
        const Block block = blockOf({hull}, random);
        const FloatingRows bodies = randomBodies(random);
        const Outcome portable = outcomeOf(InstructionSet::portable, *hull, block, bodies);
        for (InstructionSet set : setsOfThisMachine()) {
            const Outcome outcome = outcomeOf(set, *hull, block, bodies);
            EXPECT_EQ(std::memcmp(&outcome, &portable, sizeof outcome), 0) << nameOf(set);
        }
    }
}

/// Body by body.
TEST(LevelKernels, PressAsTheClipKernelsDo) {
    Random random(4);
    for (const auto& hull : closedHulls()) {
        if (hull->packed.full.packs.size() != 1) continue;
        const TrianglePack<double>& pack = hull->packed.full.packs.front();
        for (int i = 0; i < 100; ++i) {
            const Block block = blockOf({hull}, random);
            const Outcome outcome = outcomeOf(bestInstructionSet(), *hull, block, randomBodies(random));
            for (int lane = 0; lane < blockSize; ++lane) {
                const Vec3 up = get(outcome.planes.upInBody, lane);
                const PressureSums one = clipKernels<double>().press(
                    &pack, 1, {{up.x(), up.y(), up.z()}, outcome.planes.depthOfCentre.lane[lane]});
                EXPECT_TRUE(isSame(outcome.sums.depth.lane[lane], one.depth));
                EXPECT_TRUE(isSame(outcome.sums.depthMoment.x.lane[lane], one.depthMoment[0]));
                EXPECT_TRUE(isSame(outcome.sums.depthMoment.y.lane[lane], one.depthMoment[1]));
                EXPECT_TRUE(isSame(outcome.sums.depthMoment.z.lane[lane], one.depthMoment[2]));
            }
        }
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
