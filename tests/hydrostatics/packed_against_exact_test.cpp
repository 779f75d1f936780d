#include <gtest/gtest.h>

#include <limits>

#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_batch.h"
#include "bullet_buoyancy/hydrostatics/evaluate_clustered.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "support/bumpy_mesh.h"
#include "support/compare_results.h"
#include "support/known_solids.h"
#include "support/random_cases.h"
#include "support/worst_difference.h"

namespace bullet_buoyancy::test {
namespace {

using Evaluator = HydrostaticResult (*)(const Hull&, const Pose&, const WaterField&, const HydrostaticQuery&);

/// The largest from `evaluateExact`, over random poses at which the surface is within the hull's bounds.
double difference(const Hull& hull, Evaluator evaluator, Precision precision) {
    const FlatWater water(WaterFrame::fromUp({3, -4, 1}, {0.3, 0.5, 0.8}));
    HydrostaticQuery query;
    query.wettedArea = query.stiffness = true;
    query.precision = precision;
    const double weightDensity = water.density() * query.gravity;
    Random random(7);
    double worst = 0;
    for (int i = 0; i < posesAHull() / 10; ++i) {
        Pose pose;
        pose.orientation = random.orientation();
        pose.position = water.frame().originWorld() +
                        random.uniform(-1, 1) * hull.bounds.radius * water.frame().upWorld();
        const HydrostaticResult a = evaluator(hull, pose, water, query);
        const HydrostaticResult b = evaluateExact(hull, pose, water, query);
        worst = std::max({worst, relativeDifference(a, b, hull, weightDensity),
                          relativeAreaDifference(a, b, hull),
                          relativeStiffnessDifference(a, b, hull, weightDensity)});
    }
    return worst;
}

std::vector<NamedHull> meshes() {
    std::vector<NamedHull> hulls = polyhedra();
    for (int level : {1, 2, 4})
        hulls.push_back({"bumpy " + std::to_string(level), hullOf(bumpyMesh(level))});
    return hulls;
}

/// Some thousand operations on numbers of the size of the hull.
constexpr double roundingInFull = 1e-12;

/// The hull's corners, depths and areas are each rounded to 6e-8 of themselves: what all of it comes to is
/// relative to the size times the surface, which is many times the volume of a thin hull.
double roundingInSingle(const Hull& hull) {
    return 4 * std::numeric_limits<float>::epsilon() * hull.surfaceArea * hull.bounds.radius /
           hull.moments.volume;
}

TEST(PackedAgainstExact, BatchAgreesToRounding) {
    for (const NamedHull& named : meshes()) {
        EXPECT_LT(difference(*named.hull, evaluateBatch, Precision::full), roundingInFull) << named.name;
        EXPECT_LT(difference(*named.hull, evaluateBatch, Precision::single), roundingInSingle(*named.hull))
            << named.name;
    }
}

TEST(PackedAgainstExact, ClusteredAgreesToRounding) {
    for (const NamedHull& named : meshes()) {
        EXPECT_LT(difference(*named.hull, evaluateClustered, Precision::full), roundingInFull) << named.name;
        EXPECT_LT(difference(*named.hull, evaluateClustered, Precision::single),
                  roundingInSingle(*named.hull))
            << named.name;
    }
}

TEST(PackedAgainstExact, SinglePrecisionKeepsItsBound) {
    const FlatWater water(WaterFrame::zUp());
    HydrostaticQuery query;
    query.precision = Precision::single;
    Random random(3);
    for (const NamedHull& named : meshes()) {
        const Hull& hull = *named.hull;
        double error = 0, bound = 0;
        constexpr int poses = 1000;  // fewer may miss the larger errors
        for (int i = 0; i < poses; ++i) {
            Pose pose;
            pose.orientation = random.orientation();
            pose.position.z() = random.uniform(-1, 1) * hull.bounds.radius;
            const HydrostaticResult single = evaluateBatch(hull, pose, water, query);
            error = std::max(error, (single.forceWorld - evaluateExact(hull, pose, water).forceWorld).norm());
            bound = std::max(bound, single.forceErrorBound);
        }
        EXPECT_LE(error, bound) << named.name;
        EXPECT_LE(bound, 30 * error) << named.name;
    }
}

TEST(PackedAgainstExact, WhatIsNotAMeshIsEvaluatedAsEver) {
    for (const NamedHull& named : smoothSolids())
        EXPECT_EQ(difference(*named.hull, evaluate, Precision::full), 0) << named.name;
}

/// An open mesh has no moments that stand for it.
TEST(PackedAgainstExact, OpenMeshesAreEvaluatedOneByOne) {
    TriangleMesh mesh = bumpyMesh(3);
    mesh.triangles.resize(mesh.triangles.size() - 100);
    const auto hull = hullOf(mesh);
    ASSERT_FALSE(hull->meshIsClosed);
    EXPECT_EQ(difference(*hull, evaluate, Precision::full), 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
