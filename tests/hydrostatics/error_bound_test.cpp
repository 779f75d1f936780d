#include <gtest/gtest.h>

#include <algorithm>

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/water/airy_waves.h"
#include "support/known_solids.h"
#include "support/random_sea.h"
#include "support/worst_difference.h"

namespace bullet_buoyancy::test {
namespace {

/// What the reference leaves undecided, of the weight of water that the hull displaces.
constexpr double ofReference = 2e-8;

struct Case {
    const NamedHull* hull;
    RandomSea sea;
    Pose pose;
    HydrostaticQuery query;
    HydrostaticResult result, truth;

    double weight() const { return sea.water->density() * query.gravity * hull->hull->moments.volume; }
    double error() const { return (result.forceWorld - truth.forceWorld).norm() / weight(); }
    double bound() const { return result.forceErrorBound / weight(); }
};

std::vector<NamedHull> allHulls() {
    std::vector<NamedHull> hulls = polyhedra();
    for (const NamedHull& solid : smoothSolids())
        hulls.push_back(solid);
    return hulls;
}

/// Calls `visit` with `count` cases: each hull in each sort of sea in turn, at tolerances of 1e-1 to 1e-5.
template <typename Visit>
void visitCases(PressureModel pressure, int count, const Visit& visit) {
    const std::vector<NamedHull> hulls = allHulls();
    Random random(20261124);
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        Case c;
        c.hull = &hulls[i % hulls.size()];
        c.sea = randomSea(i / hulls.size(), random);
        c.query.pressure = pressure;
        c.query.time = random.uniform(0, 1000);
        c.query.tolerance = std::pow(10, random.uniform(-5, -1));
        c.pose = poseAcross(*c.sea.water, *c.hull->hull, c.query.time, random);
        c.result = evaluateExact(*c.hull->hull, c.pose, *c.sea.water, c.query);
        c.truth = evaluateReference(*c.hull->hull, c.pose, *c.sea.water, c.query);
        visit(c);
    }
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

TEST(ErrorBound, HoldsInEveryCaseAndIsNotFarFromTheError) {
    std::vector<double> ratios;
    visitCases(PressureModel::hydrostatic, posesAHull(), [&](const Case& c) {
        EXPECT_LE(c.error(), c.bound() + ofReference)
            << c.hull->name << " in " << c.sea.kind << ", tolerance " << c.query.tolerance;
        if (c.error() < 10 * ofReference) return;  // the reference cannot tell the ratio
        ratios.push_back(c.bound() / c.error());
    });
    EXPECT_LT(median(ratios), 30);
}

/// The bound of the dynamic pressure's error is rough: it only must hold.
TEST(ErrorBound, HoldsForDynamicPressure) {
    visitCases(PressureModel::waveDynamic, posesAHull() / 10, [&](const Case& c) {
        EXPECT_LE(c.error(), c.bound() + ofReference)
            << c.hull->name << " in " << c.sea.kind << ", tolerance " << c.query.tolerance;
    });
}

/// Which grows as e^(k s) with the height s over the surface. A box that hardly dips in: cells of water have
/// their centres metres above it. They cannot follow waves so short; but what they give is no more off than
/// the force itself is large.
TEST(ErrorBound, TheHeadOfShortWavesIsNotFollowedIntoTheAir) {
    const Hull box = *makeHull(boxMesh({6, 6, 6})).hull;
    AiryWavesDef def;
    def.components = {WaveComponent()};
    def.components[0].wavenumber = 20;
    def.components[0].amplitude = 0.015;
    const AiryWaves sea(WaterFrame::zUp(), def);
    const Pose pose{{0.1, 0.2, 2.7}, Eigen::Quaterniond::Identity()};
    HydrostaticQuery query;
    query.pressure = PressureModel::waveDynamic;
    query.time = 1;
    const HydrostaticResult result = evaluateExact(box, pose, sea, query);
    const HydrostaticResult truth = evaluateReference(box, pose, sea, query);
    const double error = (result.forceWorld - truth.forceWorld).norm();
    EXPECT_LE(error, result.forceErrorBound);
    EXPECT_LT(error, truth.forceWorld.norm());
}

}  // namespace
}  // namespace bullet_buoyancy::test
