#include <gtest/gtest.h>

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "support/compare_results.h"
#include "support/known_solids.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

constexpr int poses = 10000;

/// Both evaluators round some hundred operations in double precision.
constexpr double roundingOfPolyhedra = 1e-12;
/// What the evaluators promise of their quadrature along the axis.
constexpr double quadratureOfSolids = 1e-8;
constexpr double quadratureOfAreas = 1e-5;

struct WorstDifference {
    double pressure = 0, areas = 0;
};

/// Over poses at which the bounding sphere reaches the surface, near a given place on the water.
WorstDifference worstDifference(const Hull& hull, const WaterField& water, const Vec3& placeInFrame,
                                int count) {
    Random random(20261122);
    HydrostaticQuery query;
    query.wettedArea = query.waterplane = true;
    WorstDifference worst;
    for (int i = 0; i < count; ++i) {
        Pose pose;
        pose.orientation = random.orientation();
        const Vec3 centre = pose.orientation * hull.bounds.centre;
        const double height = random.uniform(-1.05, 1.05) * hull.bounds.radius;
        const WaterFrame& frame = water.frame();
        const Vec3 onSurface = frame.originWorld() + frame.worldFromFrame() * placeInFrame;
        pose.position = onSurface + height * frame.upWorld() - frame.upWorld() * frame.upWorld().dot(centre);
        const HydrostaticResult exact = evaluateExact(hull, pose, water, query);
        const HydrostaticResult reference = evaluateReference(hull, pose, water, query);
        const double pressure = relativeDifference(exact, reference, hull, water.density() * query.gravity);
        worst.pressure = std::max(worst.pressure, pressure);
        worst.areas = std::max(worst.areas, relativeAreaDifference(exact, reference, hull));
    }
    return worst;
}

TEST(ExactAgainstReference, PolyhedraAgreeToRounding) {
    const FlatWater water(WaterFrame::zUp());
    for (const NamedHull& named : polyhedra()) {
        const WorstDifference worst = worstDifference(*named.hull, water, Vec3::Zero(), poses);
        EXPECT_LT(worst.pressure, roundingOfPolyhedra) << named.name;
        EXPECT_LT(worst.areas, roundingOfPolyhedra) << named.name;
    }
}

TEST(ExactAgainstReference, TenKilometresAwayCostNoAccuracy) {
    const FlatWater water(WaterFrame::fromUp({3000, -4000, 12}, {0.3, 0.5, 0.8}));
    for (const NamedHull& named : polyhedra()) {
        const WorstDifference worst = worstDifference(*named.hull, water, {8000, 6000, 0}, poses / 10);
        EXPECT_LT(worst.pressure, roundingOfPolyhedra) << named.name;
        EXPECT_LT(worst.areas, roundingOfPolyhedra) << named.name;
    }
}

TEST(ExactAgainstReference, SmoothSolidsAgreeToQuadrature) {
    const FlatWater water(WaterFrame::yUp({0, 5, 0}));
    for (const NamedHull& named : smoothSolids()) {
        const WorstDifference worst = worstDifference(*named.hull, water, Vec3::Zero(), poses);
        EXPECT_LT(worst.pressure, quadratureOfSolids) << named.name;
        EXPECT_LT(worst.areas, quadratureOfAreas) << named.name;
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
