#include "bullet_buoyancy/water/water_frame.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

/// A rotation is made by two cross products and two normalisations: some ten roundings of numbers up to 1.
constexpr double roundingOfAxes = 10 * epsilon;

/// Along, between and near the axes, then anywhere.
std::vector<Vec3> upDirections() {
    std::vector<Vec3> ups;
    for (double x : {-1.0, 0.0, 1.0})
        for (double y : {-1.0, 0.0, 1.0})
            for (double z : {-1.0, 0.0, 1.0}) {
                if (x == 0 && y == 0 && z == 0) continue;
                ups.push_back({x, y, z});
                ups.push_back({x + 1e-9, y - 1e-12, z + 1e-15});
            }
    Random random(1);
    for (int i = 0; i < 1000; ++i)
        ups.push_back(random.uniform(0.01, 100) * random.direction());
    return ups;
}

WaterFrame randomFrame(Random& random) {
    return WaterFrame::fromUp(random.inCube(100), random.direction());
}

TEST(WaterFrame, YUpTakesTheWorldsXMinusZAndY) {
    const WaterFrame frame = WaterFrame::yUp({1, 2, 3});
    EXPECT_EQ(frame.worldFromFrame().col(0), Vec3::UnitX());
    EXPECT_EQ(frame.worldFromFrame().col(1), Vec3(-Vec3::UnitZ()));
    EXPECT_EQ(frame.worldFromFrame().col(2), Vec3::UnitY());
    EXPECT_EQ(frame.upWorld(), Vec3::UnitY());
    EXPECT_EQ(frame.originWorld(), Vec3(1, 2, 3));
}

TEST(WaterFrame, ZUpTakesTheWorldsAxes) {
    const WaterFrame frame = WaterFrame::zUp({1, 2, 3});
    EXPECT_EQ(frame.worldFromFrame(), Mat3::Identity());
    EXPECT_EQ(frame.upWorld(), Vec3::UnitZ());
    EXPECT_EQ(frame.originWorld(), Vec3(1, 2, 3));
}

TEST(WaterFrame, StandsAtTheWorldsOriginUnlessToldOtherwise) {
    EXPECT_EQ(WaterFrame::yUp().originWorld(), Vec3::Zero());
    EXPECT_EQ(WaterFrame::zUp().originWorld(), Vec3::Zero());
}

TEST(WaterFrame, FromUpGivesTheNamedFramesForTheirDirections) {
    EXPECT_EQ(WaterFrame::fromUp({1, 2, 3}, Vec3::UnitY()).worldFromFrame(),
              WaterFrame::yUp().worldFromFrame());
    EXPECT_EQ(WaterFrame::fromUp({1, 2, 3}, Vec3::UnitZ()).worldFromFrame(),
              WaterFrame::zUp().worldFromFrame());
}

TEST(WaterFrame, FromUpIsARightHandedRotationWithThatUp) {
    for (const Vec3& up : upDirections()) {
        const WaterFrame frame = WaterFrame::fromUp({4, 5, 6}, up);
        const Mat3& axes = frame.worldFromFrame();
        EXPECT_TRUE(isNear(axes.transpose() * axes, Mat3::Identity(), roundingOfAxes)) << up.transpose();
        EXPECT_NEAR(axes.determinant(), 1, roundingOfAxes) << up.transpose();
        EXPECT_TRUE(isNear(frame.upWorld(), up.normalized(), roundingOfAxes));
        EXPECT_EQ(frame.originWorld(), Vec3(4, 5, 6));
    }
}

TEST(WaterFrame, FromUpMakesTheMostNearlyHorizontalWorldAxisItsX) {
    for (const Vec3& up : upDirections()) {
        const Vec3 unit = up.normalized();
        Eigen::Index leastVertical = 0;
        const double slope = unit.cwiseAbs().minCoeff(&leastVertical);
        const Vec3 axis = Vec3::Unit(leastVertical);
        const Vec3 madeHorizontal = (axis - unit.dot(axis) * unit) / std::sqrt(1 - slope * slope);
        EXPECT_TRUE(
            isNear(WaterFrame::fromUp({0, 0, 0}, up).worldFromFrame().col(0), madeHorizontal, roundingOfAxes))
            << up.transpose();
    }
}

TEST(WaterFrame, LengthOfUpDoesNotMatter) {
    const Vec3 up(0.48, -0.6, 0.64);
    const Mat3 axes = WaterFrame::fromUp({0, 0, 0}, up).worldFromFrame();
    for (double length : {1e-100, 1e-9, 1e9, 1e100})
        EXPECT_TRUE(isNear(WaterFrame::fromUp({0, 0, 0}, length * up).worldFromFrame(), axes, roundingOfAxes))
            << length;
}

TEST(WaterFrame, PointsAndVectorsMakeTheRoundTrip) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const WaterFrame frame = randomFrame(random);
        const Vec3 inFrame = random.inCube(100);
        const Vec3 inWorld = frame.originWorld() + frame.worldFromFrame() * inFrame;
        // Coordinates are below 100 + 100 sqrt 3: each rounding is below 300 epsilon, and there are some ten.
        EXPECT_TRUE(isNear(frame.pointFromWorld(inWorld), inFrame, 3000 * epsilon));
        EXPECT_TRUE(isNear(frame.vectorFromWorld(frame.worldFromFrame() * inFrame), inFrame, 3000 * epsilon));
    }
}

TEST(WaterFrame, OriginIsAtZeroHeightAndPointsAboveItAreAbove) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const WaterFrame frame = randomFrame(random);
        EXPECT_EQ(frame.pointFromWorld(frame.originWorld()), Vec3::Zero());
        const double height = random.uniform(-10, 10);
        const Vec3 above = frame.originWorld() + height * frame.upWorld();
        // The origin's coordinates of up to 100 are added and taken away again.
        EXPECT_TRUE(isNear(frame.pointFromWorld(above), height * Vec3::UnitZ(), 1000 * epsilon));
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
