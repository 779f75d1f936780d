#include <gtest/gtest.h>

#include "bullet_buoyancy/water/flat_water.h"
#include "support/known_solids.h"
#include "support/worst_difference.h"

namespace bullet_buoyancy::test {
namespace {

/// Both evaluators round some hundred operations in double precision.
constexpr double roundingOfPolyhedra = 1e-12;
/// What the evaluators promise of their quadrature along the axis.
constexpr double quadratureOfSolids = 1e-8;
constexpr double quadratureOfAreas = 1e-5;

TEST(ExactAgainstReference, PolyhedraAgreeToRounding) {
    const FlatWater water(WaterFrame::zUp());
    for (const NamedHull& named : polyhedra()) {
        const WorstDifference worst = worstDifference(*named.hull, water, Vec3::Zero(), posesAHull());
        EXPECT_LT(worst.pressure, roundingOfPolyhedra) << named.name;
        EXPECT_LT(worst.areas, roundingOfPolyhedra) << named.name;
    }
}

TEST(ExactAgainstReference, TenKilometresAwayCostNoAccuracy) {
    const FlatWater water(WaterFrame::fromUp({3000, -4000, 12}, {0.3, 0.5, 0.8}));
    for (const NamedHull& named : polyhedra()) {
        const WorstDifference worst = worstDifference(*named.hull, water, {8000, 6000, 0}, posesAHull());
        EXPECT_LT(worst.pressure, roundingOfPolyhedra) << named.name;
        EXPECT_LT(worst.areas, roundingOfPolyhedra) << named.name;
    }
}

TEST(ExactAgainstReference, SmoothSolidsAgreeToQuadrature) {
    const FlatWater water(WaterFrame::yUp({0, 5, 0}));
    for (const NamedHull& named : smoothSolids()) {
        const WorstDifference worst = worstDifference(*named.hull, water, Vec3::Zero(), posesAHull());
        EXPECT_LT(worst.pressure, quadratureOfSolids) << named.name;
        EXPECT_LT(worst.areas, quadratureOfAreas) << named.name;
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
