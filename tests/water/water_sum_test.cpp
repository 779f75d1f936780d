#include "bullet_buoyancy/water/water_sum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/current.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "support/near.h"
#include "support/random_waves.h"
#include "water/field_checks.h"

namespace bullet_buoyancy::test {
namespace {

AiryWaves randomAiry(int count, double steepness, std::uint64_t seed) {
    Random random(seed);
    return AiryWaves(WaterFrame::zUp(), {randomWaves(count, steepness, random)});
}

TEST(Current, FallsWithDepthByItsProfile) {
    const Vec3 top(1, 2, 0);
    for (double exponent : {0.0, 1.0 / 7, 1.0, 2.0}) {
        const Current current(WaterFrame::zUp(), {top, 50, exponent});
        for (double z : {-49.0, -20.0, -1.0})
            EXPECT_TRUE(
                isNear(velocityAt(current, {3, 4, z}, 5), std::pow(1 + z / 50, exponent) * top, 1e-15));
        EXPECT_EQ(velocityAt(current, {3, 4, 7}, 5), top);
        EXPECT_EQ(velocityAt(current, {3, 4, -50.1}, 5), Vec3::Zero());
    }
    EXPECT_EQ(velocityAt(Current(WaterFrame::zUp(), {top}), {1, 2, -1e9}, 0), top);
}

TEST(Current, RunsInTheAxesOfItsFrame) {
    const WaterFrame frame = WaterFrame::yUp();
    EXPECT_TRUE(isNear(velocityAt(Current(frame, {{1, 0, -2}}), {0, 0, -1}, 0), Vec3(1, 2, 0), 1e-15));
    EXPECT_TRUE(Current(frame, {}).bounds().still);
    EXPECT_FALSE(Current(frame, {{1, 0, 0}}).bounds().still);
    EXPECT_TRUE(Current(frame, {{1, 0, 0}}).bounds().isFlat());
}

TEST(Current, RefusesWhatIsNoProfile) {
    const WaterFrame frame = WaterFrame::zUp();
    EXPECT_EQ(Current(frame, {{1, 0, 0}, 0, 1}).status().error, WaterError::badDepth);
    EXPECT_EQ(Current(frame, {{1, 0, 0}, 1, -1}).status().error, WaterError::badProfile);
    EXPECT_EQ(Current(frame, {{NAN, 0, 0}, 1, 1}).status().error, WaterError::notFinite);
    EXPECT_TRUE(Current(frame, {{1, 0, 0}, 0, 1}).bounds().still);
}

TEST(WaterSum, IsTheFieldOfAllComponents) {
    // Swell and wind sea are the same as one field of the waves of both, velocity and head included.
    Random random(1);
    const auto swell = randomWaves(3, 0.1, random), windSea = randomWaves(9, 0.2, random);
    auto both = swell;
    both.insert(both.end(), windSea.begin(), windSea.end());
    const AiryWaves a(WaterFrame::zUp(), {swell}), b(WaterFrame::zUp(), {windSea}),
        all(WaterFrame::zUp(), {both});
    const WaterSum sum({&a, &b});
    // More points than are summed at once.
    const Eigen::Index count = 71;
    Eigen::ArrayX3d points(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
        points.row(i) << random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-5, 1);
    const auto compare = [&](auto columns, const auto& ask) {
        using Answers = Eigen::Array<double, Eigen::Dynamic, decltype(columns)::value>;
        Answers ofSum = Answers::Constant(count, columns, 99), ofAll = ofSum;
        ask(sum, ofSum);
        ask(all, ofAll);
        // Sums in another order of numbers up to 10.
        EXPECT_LE((ofSum - ofAll).abs().maxCoeff(), 1e-13) << columns;
    };
    compare(std::integral_constant<int, 3>(), [&](const WaterField& field, auto& answers) {
        field.sampleSurface(points.leftCols<2>(), 3, answers);
    });
    compare(std::integral_constant<int, 7>(), [&](const WaterField& field, auto& answers) {
        field.expandSurface(points.leftCols<2>(), 3, answers);
        answers.col(6) = 0;  // a bound, wider for a sum
    });
    compare(std::integral_constant<int, 10>(),
            [&](const WaterField& field, auto& answers) { field.expandWaveHead(points, 3, answers); });
    compare(std::integral_constant<int, 3>(),
            [&](const WaterField& field, auto& answers) { field.sampleVelocity(points, 3, answers); });
    EXPECT_NEAR(sum.bounds().curvatureChange, all.bounds().curvatureChange, 1e-13);
    EXPECT_NEAR(sum.headCurvatureChange(0.5), all.headCurvatureChange(0.5), 1e-13);
}

TEST(WaterSum, AddsFieldsOfAllSorts) {
    Random random(2);
    const AiryWaves airy = randomAiry(5, 0.2, 3);
    const GerstnerWaves gerstner(WaterFrame::zUp(), {randomWaves(4, 0.3, random)});
    const Current current(WaterFrame::zUp(), {{1, 2, 0}, 50, 1});
    const WaterSum sum({&airy, &gerstner, &current}, 1026);
    EXPECT_EQ(sum.density(), 1026);
    for (int i = 0; i < 100; ++i) {
        const double x = random.uniform(-50, 50), y = random.uniform(-50, 50), t = random.uniform(0, 50);
        const double etaA = surfaceAt(airy, x, y, t)[0], etaG = surfaceAt(gerstner, x, y, t)[0];
        EXPECT_NEAR(surfaceAt(sum, x, y, t)[0], etaA + etaG, 1e-14);
        // Each field's depth is from the common surface.
        const double s = random.uniform(-8, 2);
        EXPECT_TRUE(isNear(velocityAt(sum, {x, y, etaA + etaG + s}, t),
                           velocityAt(airy, {x, y, etaA + s}, t) + velocityAt(gerstner, {x, y, etaG + s}, t) +
                               velocityAt(current, {x, y, s}, t),
                           1e-8));
        EXPECT_NEAR(headAt(sum, x, y, s, t)[0], headAt(airy, x, y, s, t)[0] + etaG, 1e-13);
    }
    expectSurfaceDerivatives(sum, {1e-4, 1e-7, 100});
    expectHeadDerivatives(sum, {1e-4, 1e-7, 100});
}

TEST(WaterSum, KeepsWithinItsBounds) {
    Random random(4);
    const AiryWaves airy = randomAiry(2, 0.3, 5);
    const GerstnerWaves gerstner(WaterFrame::zUp(), {randomWaves(1, 0.3, random)});
    const WaterSum sum({&airy, &gerstner});
    const WaterBounds bounds = sum.bounds(), found = searchBounds(sum, 60, true);
    EXPECT_LE(found.elevation, bounds.elevation);
    EXPECT_LE(found.slope, bounds.slope);
    EXPECT_LE(found.curvature, bounds.curvature);
    EXPECT_LE(found.curvatureChange, bounds.curvatureChange);
    for (double above : {0.0, 1.0})
        EXPECT_LE(searchHeadCurvatureChange(sum, 60, -6, above), sum.headCurvatureChange(above));
    // Short waves that ride on steep ones: alone they would promise less than they need.
    EXPECT_GT(sum.headCurvatureChange(0), airy.headCurvatureChange(0) + gerstner.headCurvatureChange(0));
}

TEST(WaterSum, IsStillIfAllAre) {
    const FlatWater flat(WaterFrame::zUp()), flowing(WaterFrame::zUp(), {1000, {1, 0, 0}});
    EXPECT_TRUE(WaterSum({&flat, &flat}).bounds().still);
    EXPECT_TRUE(WaterSum({&flat, &flat}).bounds().isFlat());
    EXPECT_EQ(WaterSum({&flat, &flat}).bounds().curvatureChange, 0);
    EXPECT_FALSE(WaterSum({&flat, &flowing}).bounds().still);
}

}  // namespace
}  // namespace bullet_buoyancy::test
