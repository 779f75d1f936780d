#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "support/known_solids.h"
#include "support/random_sea.h"
#include "support/worst_difference.h"

namespace bullet_buoyancy::test {
namespace {

/// What the reference leaves undecided, of the weight of water that the hull displaces.
constexpr double ofReference = 2e-8;

struct Case {
    std::string name;
    double tolerance, error, bound;  // of the force, over the weight of water that the hull displaces
    double volumeError;              // over the hull's volume
};

Case anyCase(const NamedHull& named, const RandomSea& sea, PressureModel pressure, Random& random) {
    const Hull& hull = *named.hull;
    HydrostaticQuery query;
    query.pressure = pressure;
    query.time = random.uniform(0, 1000);
    query.tolerance = std::pow(10, random.uniform(-5, -1));
    const Pose pose = poseAcross(*sea.water, hull, query.time, random);
    const HydrostaticResult result = evaluateExact(hull, pose, *sea.water, query),
                            truth = evaluateReference(hull, pose, *sea.water, query);
    const double volume = hull.moments.volume, weight = sea.water->density() * query.gravity * volume;
    return {named.name + " in " + sea.kind, query.tolerance,
            (result.forceWorld - truth.forceWorld).norm() / weight, result.forceErrorBound / weight,
            std::abs(result.submergedVolume - truth.submergedVolume) / volume};
}

/// Calls `visit` with 1,000 cases: each solid in each sort of sea in turn.
template <typename Visit>
void visitCases(PressureModel pressure, std::uint64_t seed, const Visit& visit) {
    const std::vector<NamedHull> hulls = smoothSolids();
    Random random(seed);
    for (std::size_t i = 0; i < std::size_t(posesAHull() / 10); ++i)
        visit(anyCase(hulls[i % hulls.size()], randomSea(i / hulls.size(), random), pressure, random));
}

TEST(SolidInWaves, BoundHoldsAndIsNotFarFromTheError) {
    std::vector<double> ratios;
    visitCases(PressureModel::hydrostatic, 4, [&](const Case& c) {
        EXPECT_LE(c.error, c.bound + ofReference) << c.name << ", tolerance " << c.tolerance;
        EXPECT_LE(c.volumeError, 3 * c.bound + 10 * ofReference) << c.name << ", tolerance " << c.tolerance;
        if (c.error > 10 * ofReference) ratios.push_back(c.bound / c.error);
    });
    const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    EXPECT_LT(*middle, 40);
}

TEST(SolidInWaves, BoundHoldsWherePressureDecays) {
    visitCases(PressureModel::waveDynamic, 5, [&](const Case& c) {
        EXPECT_LE(c.error, c.bound + ofReference) << c.name << ", tolerance " << c.tolerance;
    });
}

/// Of two spheres of which one is almost within the other, the larger lacks no more than a cap.
TEST(SolidInWaves, BoundHoldsWhereASphereEndsShortOfItsPole) {
    Random random(6);
    const NamedHull hull{"nearly nested spheres",
                         hullOf({makeTaperedCapsule(Vec3::Zero(), 0.1, 0.55 * Vec3::UnitX(), 0.6)})};
    for (std::size_t i = 0; i < std::size_t(posesAHull() / 20); ++i) {
        const Case c = anyCase(hull, randomSea(i, random), PressureModel::hydrostatic, random);
        EXPECT_LE(c.error, c.bound + ofReference) << c.name << ", tolerance " << c.tolerance;
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
