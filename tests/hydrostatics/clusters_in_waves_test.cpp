#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/hydrostatics/evaluate_batch.h"
#include "bullet_buoyancy/hydrostatics/evaluate_clustered.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "support/bumpy_mesh.h"
#include "support/compare_results.h"
#include "support/known_solids.h"
#include "support/quadratic_water.h"
#include "support/random_sea.h"
#include "support/worst_difference.h"

namespace bullet_buoyancy::test {
namespace {

/// Meshes of several packs to several levels of clusters, compact and long, with small triangles and large
/// ones.
std::vector<NamedHull> hullsOfManyTriangles() {
    return {{"bumpy 2", hullOf(bumpyMesh(2))},
            {"bumpy 3", hullOf(bumpyMesh(3))},
            {"bumpy 4", hullOf(bumpyMesh(4))},
            {"Wigley", hullOf(wigleyMesh(6, 1.2, 0.6, 40, 10))}};
}

struct Case {
    const NamedHull* hull;
    RandomSea sea;
    Pose pose;
    HydrostaticQuery query;

    double weightDensity() const { return sea.water->density() * query.gravity; }
    double weight() const { return weightDensity() * hull->hull->moments.volume; }

    template <typename Evaluator>
    HydrostaticResult by(const Evaluator& evaluator) const {
        return evaluator(*hull->hull, pose, *sea.water, query);
    }
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.hull->name << " in " << c.sea.kind << ", tolerance " << c.query.tolerance;
}

/// Calls `visit` with each hull in each sort of sea in turn, at tolerances of 1e-1 to 1e-5.
template <typename Visit>
void visitCases(PressureModel pressure, int count, const Visit& visit) {
    const std::vector<NamedHull> hulls = hullsOfManyTriangles();
    Random random(20261127);
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        Case c;
        c.hull = &hulls[i % hulls.size()];
        c.sea = randomSea(i / hulls.size(), random);
        c.query.pressure = pressure;
        c.query.time = random.uniform(0, 1000);
        c.query.tolerance = std::pow(10, random.uniform(-5, -1));
        c.query.wettedArea = c.query.waterplane = true;
        c.pose = poseAcross(*c.sea.water, *c.hull->hull, c.query.time, random);
        visit(c);
    }
}

constexpr PressureModel bothModels[] = {PressureModel::hydrostatic, PressureModel::waveDynamic};

/// What the reference leaves undecided, of the weight of water that the hull displaces.
constexpr double ofReference = 2e-8;

TEST(ClustersInWaves, ErrorBoundHolds) {
    for (PressureModel model : bothModels)
        visitCases(model, posesAHull() / 20, [](const Case& c) {
            const HydrostaticResult result = c.by(evaluateClustered), truth = c.by(evaluateReference);
            EXPECT_LE((result.forceWorld - truth.forceWorld).norm(),
                      result.forceErrorBound + ofReference * c.weight())
                << c;
        });
}

/// Each is within its bound of the same truth.
TEST(ClustersInWaves, ForceIsWithinBothBoundsOfThatOneByOne) {
    for (PressureModel model : bothModels)
        visitCases(model, posesAHull() / 4, [](const Case& c) {
            const HydrostaticResult result = c.by(evaluateClustered), law = c.by(evaluateExact);
            EXPECT_LE((result.forceWorld - law.forceWorld).norm(),
                      result.forceErrorBound + law.forceErrorBound + 1e-12 * c.weight())
                << c;
        });
}

/// Wherever triangles one by one keep the tolerance, with no more samples: but for a few cases in a hundred,
/// in which what their bound would be is not estimated well.
TEST(ClustersInWaves, KeepTheToleranceAsTrianglesOneByOneDo) {
    constexpr double few = 0.02;
    for (PressureModel model : bothModels) {
        int kept = 0, keptOneByOne = 0, withMoreSamples = 0;
        visitCases(model, posesAHull() / 4, [&](const Case& c) {
            const HydrostaticResult result = c.by(evaluateClustered), law = c.by(evaluateExact);
            const double allowed = c.query.tolerance * c.weight();
            kept += result.forceErrorBound <= allowed;
            keptOneByOne += law.forceErrorBound <= allowed;
            withMoreSamples += result.waterSamples > law.waterSamples;
        });
        EXPECT_GE(kept, (1 - few) * keptOneByOne);
        EXPECT_LE(withMoreSamples, few * posesAHull() / 4);
    }
}

double longestSide(const TriangleMesh& mesh) {
    double longest = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            longest = std::max(longest, (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm());
    return longest;
}

/// What no bound is stated for is as near to that one by one as the force must be: moments, volume and
/// energy. So are areas, but that triangles one by one lift their shadows to a surface that is linear over
/// each: it bends by no more than an eighth of the curvature times the square of the longest side.
TEST(ClustersInWaves, AllElseIsWithinTheToleranceOfThatOneByOne) {
    for (PressureModel model : bothModels)
        visitCases(model, posesAHull() / 4, [](const Case& c) {
            const HydrostaticResult result = c.by(evaluateClustered), law = c.by(evaluateExact);
            const double bounds = (result.forceErrorBound + law.forceErrorBound) / c.weight();
            const double allowed = std::max(c.query.tolerance, bounds);
            EXPECT_LE(relativeDifference(result, law, *c.hull->hull, c.weightDensity()), allowed) << c;
            const double side = longestSide(c.hull->hull->mesh);
            const double lift =
                c.sea.water->bounds().curvature * side * side / 8 / c.hull->hull->bounds.radius;
            EXPECT_LE(relativeAreaDifference(result, law, *c.hull->hull), allowed + lift) << c;
        });
}

/// Turned at random, near the surface of water that is near z = 0 there.
Pose nearTheMiddle(const Hull& hull, Random& random) {
    const Vec3 place = random.inCube(1);
    Pose pose;
    pose.orientation = random.orientation();
    pose.position =
        place.cwiseProduct(Vec3(1, 1, hull.bounds.radius / 2)) - pose.orientation * hull.bounds.centre;
    return pose;
}

/// On which expansions make no error, only triangles one by one do: they leave out what the surface bends
/// over each where that is less than a sixteenth of the error allowed.
TEST(ClustersInWaves, ForceAndVolumeAreExactUnderAParaboloid) {
    const QuadraticWater water(0, {0.1, -0.05}, {0.2, -0.1});
    const HydrostaticQuery query{standardGravity, 0, PressureModel::hydrostatic, 1e-4};
    const double weightDensity = water.density() * query.gravity;
    Random random(5);
    for (const NamedHull& named : hullsOfManyTriangles())
        for (int i = 0; i < 100; ++i) {
            const Hull& hull = *named.hull;
            const Pose pose = nearTheMiddle(hull, random);
            const HydrostaticResult result = evaluateClustered(hull, pose, water, query);
            const HydrostaticResult law = evaluateExact(hull, pose, water, query);
            const double leftOut = query.tolerance / 16 * hull.moments.volume;
            EXPECT_LE((result.forceWorld - law.forceWorld).norm(), weightDensity * leftOut) << named.name;
            EXPECT_NEAR(result.submergedVolume, law.submergedVolume, leftOut) << named.name;
            EXPECT_LE(relativeDifference(result, law, hull, weightDensity), query.tolerance) << named.name;
        }
}

TEST(ClustersInWaves, PacksAreSummedUpAsClusters) {
    visitCases(PressureModel::hydrostatic, 100, [](const Case& c) {
        const HydrostaticResult packs = c.by(evaluateBatch), clusters = c.by(evaluateClustered);
        EXPECT_LE(relativeDifference(packs, clusters, *c.hull->hull, c.weightDensity()), 1e-12) << c;
    });
}

}  // namespace
}  // namespace bullet_buoyancy::test
