#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolverMt.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <gtest/gtest.h>

#include <cstring>

#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/study_seas.h"
#include "scenes/thread_scheduler.h"
#include "support/mixed_fleet.h"

namespace bullet_buoyancy::test {
namespace {

constexpr int steps = 30;
constexpr int bodies = 100;  // a few pieces, the last of them smaller

using Bits = std::vector<double>;

void append(Bits& bits, const btVector3& v) {
    bits.insert(bits.end(), {double(v.x()), double(v.y()), double(v.z())});
}

/// All that tells of the fleet's motion.
Bits stateOf(MixedFleet& fleet) {
    Bits bits;
    for (const auto& body : fleet.bodies()) {
        for (int row = 0; row < 3; ++row)
            append(bits, body->getWorldTransform().getBasis()[row]);
        append(bits, body->getWorldTransform().getOrigin());
        append(bits, body->getLinearVelocity());
        append(bits, body->getAngularVelocity());
        const BodyReport report = fleet.buoyancy().report(*body);
        append(bits, report.forceWorld);
        bits.insert(bits.end(), {report.totalEnergy(), report.energy.expected(), double(report.evaluations),
                                 double(report.state)});
    }
    return bits;
}

bool isSame(const Bits& a, const Bits& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

Bits afterwards(const WaterField& water, int count = bodies) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    MixedFleet fleet(world, water, count);
    for (int i = 0; i < steps; ++i)
        fleet.step();
    return stateOf(fleet);
}

Bits afterwardsInAWorldMt(const WaterField& water) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcherMt dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btConstraintSolverPoolMt solvers(4);
    btSequentialImpulseConstraintSolverMt solver;
    btDiscreteDynamicsWorldMt world(&dispatcher, &broadphase, &solvers, &solver, &configuration);
    MixedFleet fleet(world, water, bodies);
    for (int i = 0; i < steps; ++i)
        fleet.step();
    return stateOf(fleet);
}

void expectSameByAnyNumberOfThreads(const WaterField& water) {
    const Bits byItself = afterwards(water);
    for (int threads : {1, 2, 4, 8}) {
        scenes::ThreadScheduler scheduler(threads);
        EXPECT_TRUE(isSame(afterwards(water), byItself)) << threads;
        EXPECT_EQ(scheduler.handedOver(), threads > 1 ? steps : 0);
    }
}

TEST(ManyBodies, AreSteppedAlikeByAnyNumberOfThreadsInFlatWater) {
    expectSameByAnyNumberOfThreads(FlatWater(WaterFrame::zUp()));
}

TEST(ManyBodies, AreSteppedAlikeByAnyNumberOfThreadsInWaves) {
    scenes::StudySeaDef def;
    def.significantHeight = 0.5;
    def.components = 8;
    expectSameByAnyNumberOfThreads(*scenes::airySea("sea", def).water);
}

TEST(ManyBodies, AreNotSharedOutIfTheyAreFew) {
    const FlatWater water(WaterFrame::zUp());
    scenes::ThreadScheduler scheduler(4);
    afterwards(water, 20);
    EXPECT_EQ(scheduler.handedOver(), 0);
}

/// Bullet itself steps a world like this in parallel only where it was built so.
TEST(ManyBodies, FloatInAWorldMt) {
    const FlatWater water(WaterFrame::zUp());
    Bits byOne;
    {
        scenes::ThreadScheduler scheduler(1);
        byOne = afterwardsInAWorldMt(water);
    }
    scenes::ThreadScheduler scheduler(4);
    EXPECT_TRUE(isSame(afterwardsInAWorldMt(water), byOne));
    EXPECT_GT(scheduler.handedOver(), 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
