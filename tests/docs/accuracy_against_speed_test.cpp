// The snippets of the guide "Choose accuracy against speed".

#include <bullet_buoyancy/bullet_buoyancy.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "docs/pool.h"
#include "support/known_solids.h"

using namespace bullet_buoyancy;

namespace {

AiryWaves roughSea() {
    SeaStateDef state;
    state.spectrum.significantHeight = 1;
    state.spectrum.peakPeriod = 6;
    state.spreading = 10;
    AiryWavesDef waves;
    waves.components = makeSeaState(state).components;
    return AiryWaves(WaterFrame::yUp(), waves);
}

struct Measured {
    double error, bound;
    int samples;
};

Measured measure(const Hull& launch, const Pose& pose, const WaterField& sea, double tolerance) {
    // [snippet]
    HydrostaticQuery query;
    query.tolerance = tolerance;
    query.time = 10;
    const HydrostaticResult fast = evaluate(launch, pose, sea, query);
    const HydrostaticResult truth = evaluateReference(launch, pose, sea, query);  // slow

    const double weight = sea.density() * query.gravity * launch.moments.volume;
    const double error = (fast.forceWorld - truth.forceWorld).norm() / weight;
    const double bound = fast.forceErrorBound / weight;
    std::printf("%.0e: error %.1e, bound %.1e, %d samples\n", tolerance, error, bound, fast.waterSamples);
    // [end]
    return {error, bound, fast.waterSamples};
}

TEST(AccuracyAgainstSpeed, ErrorsKeepWithinTheBoundAndTheTolerance) {
    const AiryWaves sea = roughSea();
    const auto launch = test::hullOf(test::boxMesh({6, 1.5, 2}));
    int samples = 0;
    for (double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
        const Measured measured = measure(*launch, Pose(), sea, tolerance);
        EXPECT_LE(measured.error, measured.bound + 1e-8) << tolerance;  // of the reference
        EXPECT_LE(measured.bound, tolerance);
        EXPECT_GE(measured.samples, samples);
        samples = measured.samples;
    }
}

TEST(AccuracyAgainstSpeed, TheActionReportsItsBound) {
    const AiryWaves sea = roughSea();
    test::Pool pool;
    btRigidBody& launch = pool.addBox({6, 1.5, 2}, 9000, {0, 0.5, 0});
    // [snippet]
    BuoyancySettings settings;
    settings.tolerance = 1e-2;               // of the force, in waves
    settings.precision = Precision::single;  // of the sums over triangles
    BuoyancyAction buoyancy(sea, settings);
    // [end]
    pool.world.addAction(&buoyancy);
    ASSERT_TRUE(buoyancy.addBody(launch));
    pool.run(5);
    // [snippet]
    const BodyReport report = buoyancy.report(launch);
    std::printf("to %.0f N, by %d evaluations with %d samples of the water\n", report.forceErrorBound,
                report.evaluations, report.waterSamples);
    // [end]
    pool.world.removeAction(&buoyancy);
    const double displaced = sea.density() * 9.81 * 18;  // N, by the whole box
    EXPECT_GT(report.forceErrorBound, 0);
    EXPECT_LE(report.forceErrorBound, settings.tolerance * displaced);
    EXPECT_GE(report.evaluations, 1);
    EXPECT_GE(report.waterSamples, report.evaluations);
}

}  // namespace
