#include "bullet_buoyancy/water/height_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/water/function_water.h"
#include "support/near.h"
#include "support/random_cases.h"
#include "water/field_checks.h"

namespace bullet_buoyancy::test {
namespace {

constexpr int nodesX = 12, nodesY = 9;
constexpr double spacing = 2.5;
const Vec2 origin(-3, 7);

HeightGridDef gridDef(bool periodic) {
    HeightGridDef def;
    def.nodesX = nodesX;
    def.nodesY = nodesY;
    def.spacing = spacing;
    def.origin = origin;
    def.periodic = periodic;
    return def;
}

template <typename Height>
std::vector<double> heightsOf(const Height& height) {
    std::vector<double> heights;
    for (int y = 0; y < nodesY; ++y)
        for (int x = 0; x < nodesX; ++x)
            heights.push_back(height(origin.x() + x * spacing, origin.y() + y * spacing));
    return heights;
}

std::vector<double> randomHeights(std::uint64_t seed) {
    Random random(seed);
    return heightsOf([&](double, double) { return random.uniform(-1, 1); });
}

HeightGrid randomGrid(bool periodic, std::uint64_t seed) {
    HeightGrid grid(WaterFrame::zUp(), gridDef(periodic));
    EXPECT_TRUE(grid.setHeights(randomHeights(seed).data()).accepted());
    return grid;
}

TEST(HeightGrid, GoesThroughItsNodes) {
    for (bool periodic : {false, true}) {
        const std::vector<double> heights = randomHeights(1);
        HeightGrid grid(WaterFrame::zUp(), gridDef(periodic));
        grid.setHeights(heights.data());
        for (int y = 0; y < nodesY; ++y)
            for (int x = 0; x < nodesX; ++x)
                EXPECT_NEAR(surfaceAt(grid, origin.x() + x * spacing, origin.y() + y * spacing, 0)[0],
                            heights[std::size_t(x + y * nodesX)], 1e-14);
    }
}

TEST(HeightGrid, IsExactForQuadraticsAwayFromItsEdges) {
    // Catmull-Rom splines are exact for polynomials up to the second degree along each axis.
    const auto height = [](double x, double y) {
        return 0.3 + 0.1 * x - 0.02 * x * x * y + 0.01 * y * y * x;
    };
    HeightGrid grid(WaterFrame::zUp(), gridDef(false));
    grid.setHeights(heightsOf(height).data());
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const double x = origin.x() + spacing * random.uniform(1, nodesX - 2);
        const double y = origin.y() + spacing * random.uniform(1, nodesY - 2);
        const Eigen::Array3d sample = surfaceAt(grid, x, y, 0);
        // Sums of sixteen heights of up to some 500 m.
        EXPECT_NEAR(sample[0], height(x, y), 1e-12 * 500);
        EXPECT_NEAR(sample[1], 0.1 - 0.04 * x * y + 0.01 * y * y, 1e-12 * 500);
        EXPECT_NEAR(sample[2], -0.02 * x * x + 0.02 * y * x, 1e-12 * 500);
    }
}

TEST(HeightGrid, ConvergesToAWaveWithTheThirdPowerOfItsSpacing) {
    const auto worst = [](double size) {
        HeightGridDef def;
        def.nodesX = def.nodesY = 64;
        def.spacing = size;
        std::vector<double> heights;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                heights.push_back(std::sin(0.3 * size * x + 0.2 * size * y));
        HeightGrid grid(WaterFrame::zUp(), def);
        grid.setHeights(heights.data());
        Random random(3);
        double largest = 0;
        for (int i = 0; i < 2000; ++i) {
            const double x = size * random.uniform(1, 62), y = size * random.uniform(1, 62);
            largest = std::max(largest, std::abs(surfaceAt(grid, x, y, 0)[0] - std::sin(0.3 * x + 0.2 * y)));
        }
        return largest;
    };
    EXPECT_LT(worst(0.5), worst(1) / 7);
}

TEST(HeightGrid, HasTheSlopesOfItsSurface) {
    Random random(4);
    const double h = 1e-5;
    for (bool periodic : {false, true}) {
        const HeightGrid grid = randomGrid(periodic, 4);
        for (int i = 0; i < 1000; ++i) {
            // Beyond the edges too; differences across a jump of curvature of up to 10 / m are off by h times
            // it.
            const double x = random.uniform(-20, 40), y = random.uniform(-10, 45);
            const Eigen::Array3d sample = surfaceAt(grid, x, y, 0);
            EXPECT_NEAR(sample[1],
                        (surfaceAt(grid, x + h, y, 0)[0] - surfaceAt(grid, x - h, y, 0)[0]) / (2 * h), 1e-4);
            EXPECT_NEAR(sample[2],
                        (surfaceAt(grid, x, y + h, 0)[0] - surfaceAt(grid, x, y - h, 0)[0]) / (2 * h), 1e-4);
        }
    }
}

TEST(HeightGrid, WrapsWhereItIsPeriodic) {
    const HeightGrid grid = randomGrid(true, 5);
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const double x = random.uniform(-100, 100), y = random.uniform(-100, 100);
        const Eigen::Array3d a = surfaceAt(grid, x, y, 0);
        const Eigen::Array3d b = surfaceAt(grid, x + 3 * nodesX * spacing, y - 2 * nodesY * spacing, 0);
        EXPECT_LE((a - b).abs().maxCoeff(), 1e-12);
    }
}

TEST(HeightGrid, IsLevelBeyondEdgesThatDoNotWrap) {
    const HeightGrid grid = randomGrid(false, 6);
    const Eigen::Array3d corner = surfaceAt(grid, origin.x(), origin.y(), 0);
    for (double far : {2.001 * spacing, 1e3, 1e12, double(INFINITY)}) {
        const Eigen::Array3d sample = surfaceAt(grid, origin.x() - far, origin.y() - far, 0);
        EXPECT_NEAR(sample[0], corner[0], 1e-14);
        EXPECT_NEAR(sample[1], 0, 1e-14);
        EXPECT_NEAR(sample[2], 0, 1e-14);
    }
}

TEST(HeightGrid, KeepsWithinItsBounds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        for (bool periodic : {false, true}) {
            const HeightGrid grid = randomGrid(periodic, seed);
            const WaterBounds bounds = grid.bounds(), found = searchBounds(grid, 45, false);
            EXPECT_LE(found.elevation, bounds.elevation * (1 + 1e-12));
            EXPECT_LE(found.slope, bounds.slope * (1 + 1e-12));
            EXPECT_LE(found.curvature, bounds.curvature * (1 + 1e-6));
            EXPECT_TRUE(std::isinf(bounds.curvatureChange));
            // Nor are they idle, even for heights that have nothing to do with their neighbours'.
            EXPECT_GE(found.elevation, 0.6 * bounds.elevation);
            EXPECT_GE(found.slope, 0.3 * bounds.slope);
            EXPECT_GE(found.curvature, 0.2 * bounds.curvature);
        }
}

TEST(HeightGrid, TakesSinglePrecisionAndRates) {
    const std::vector<double> heights = randomHeights(7), rates = randomHeights(8);
    const std::vector<float> heightsF(heights.begin(), heights.end()), ratesF(rates.begin(), rates.end());
    HeightGrid grid(WaterFrame::zUp(), gridDef(false));
    grid.setHeights(heightsF.data(), ratesF.data());
    const Vec3 node(origin.x() + 2 * spacing, origin.y() + 3 * spacing, -1);
    EXPECT_NEAR(surfaceAt(grid, node.x(), node.y(), 0)[0], heightsF[2 + 3 * nodesX], 1e-14);
    EXPECT_TRUE(isNear(velocityAt(grid, node, 0), Vec3(0, 0, ratesF[2 + 3 * nodesX]), 1e-14));
    grid.setHeights(heights.data());
    EXPECT_EQ(velocityAt(grid, node, 0), Vec3::Zero());
}

TEST(HeightGrid, IsStillOnlyIfItsUserSaysSo) {
    HeightGridDef def = gridDef(false);
    EXPECT_FALSE(HeightGrid(WaterFrame::zUp(), def).bounds().still);
    EXPECT_TRUE(HeightGrid(WaterFrame::zUp(), def).bounds().isFlat());
    def.moves = false;
    EXPECT_TRUE(HeightGrid(WaterFrame::zUp(), def).bounds().still);
}

TEST(HeightGrid, RefusesWhatIsNoGrid) {
    HeightGridDef def = gridDef(false);
    def.nodesX = 1;
    HeightGrid refused(WaterFrame::zUp(), def);
    EXPECT_EQ(refused.status().error, WaterError::badGrid);
    EXPECT_EQ(refused.setHeights(randomHeights(1).data()).error, WaterError::badGrid);
    EXPECT_EQ(surfaceAt(refused, 1, 2, 3)[0], 0);
    def = gridDef(false);
    def.spacing = NAN;
    EXPECT_EQ(HeightGrid(WaterFrame::zUp(), def).status().error, WaterError::notFinite);

    HeightGrid grid = randomGrid(false, 9);
    const double before = surfaceAt(grid, 1, 8, 0)[0];
    std::vector<double> heights = randomHeights(10);
    heights[5] = NAN;
    EXPECT_EQ(grid.setHeights(heights.data()).error, WaterError::notFinite);
    EXPECT_EQ(surfaceAt(grid, 1, 8, 0)[0], before);
}

TEST(FunctionWater, AsksItsFunctions) {
    FunctionWaterDef def;
    def.surface = [](double x, double y, double t) {
        return Eigen::Array3d(0.1 * std::sin(x) + y + t, 0.1 * std::cos(x), 1);
    };
    def.bounds = {10, 1.1, 0.1, 0.1, 0, false};
    const FunctionWater still(WaterFrame::zUp(), def);
    EXPECT_EQ(velocityAt(still, {1, 2, 3}, 4), Vec3::Zero());
    def.velocity = [](const Vec3& point, double t) { return Vec3(t * point); };
    const FunctionWater water(WaterFrame::zUp(), def);
    EXPECT_EQ(surfaceAt(water, 1, 2, 3)[0], 0.1 * std::sin(1.0) + 5);
    EXPECT_EQ(velocityAt(water, {1, 2, 3}, 4), Vec3(4, 8, 12));
    EXPECT_EQ(water.bounds().slope, 1.1);
    EXPECT_FALSE(water.bounds().still);
    // It has no second derivatives to go with it.
    EXPECT_TRUE(std::isinf(water.bounds().curvatureChange));
}

}  // namespace
}  // namespace bullet_buoyancy::test
