#include "bullet_buoyancy/water/flat_water.h"

#include <gtest/gtest.h>

#include "bullet_buoyancy/water/water_plane.h"
#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

Eigen::ArrayX3d randomPoints(Eigen::Index count, Random& random) {
    Eigen::ArrayX3d points(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
        points.row(i) = random.inCube(1000).transpose().array();
    return points;
}

Pose randomPose(double halfSize, Random& random) {
    return {random.inCube(halfSize), random.orientation()};
}

TEST(FlatWater, IsFlatEverywhereAndAlways) {
    Random random(1);
    const FlatWater water(WaterFrame::fromUp({1, 2, 3}, {1, 2, 3}), {1000, {1, 1, 1}});
    const Eigen::ArrayX2d points = randomPoints(7, random).leftCols(2);
    for (double time : {-1.0, 0.0, 1e6}) {
        Eigen::ArrayX3d samples = Eigen::ArrayX3d::Constant(7, 3, 99);
        water.sampleSurface(points, time, samples);
        EXPECT_TRUE((samples == 0).all()) << time;
    }
}

TEST(FlatWater, FillsOnlyTheRowsItIsGiven) {
    Random random(2);
    const FlatWater water(WaterFrame::zUp(), {1000, {1, 2, 3}});
    const Eigen::ArrayX3d points = randomPoints(9, random);
    Eigen::ArrayX3d surface = Eigen::ArrayX3d::Constant(9, 3, 99), velocity = surface;
    water.sampleSurface(points.middleRows(2, 4).leftCols(2), 0, surface.middleRows(2, 4));
    water.sampleVelocity(points.middleRows(2, 4), 0, velocity.middleRows(2, 4));
    for (Eigen::Index row = 0; row < 9; ++row) {
        const bool asked = row >= 2 && row < 6;
        EXPECT_TRUE((surface.row(row) == (asked ? 0.0 : 99.0)).all()) << row;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            EXPECT_EQ(velocity(row, axis), asked ? double(axis + 1) : 99.0) << row;
    }
}

TEST(FlatWater, HasNoElevationSlopeOrCurvature) {
    const WaterBounds bounds = FlatWater(WaterFrame::yUp({0, 5, 0}), {1000, {3, 0, 0}}).bounds();
    EXPECT_EQ(bounds.elevation, 0);
    EXPECT_EQ(bounds.slope, 0);
    EXPECT_EQ(bounds.curvature, 0);
}

TEST(FlatWater, IsStillUnlessItFlows) {
    const WaterFrame frame = WaterFrame::zUp();
    EXPECT_TRUE(FlatWater(frame).bounds().still);
    EXPECT_TRUE(FlatWater(frame, {1000, Vec3::Zero()}).bounds().still);
    for (int axis = 0; axis < 3; ++axis)
        for (double speed : {1.0, -1e-3, 1e-300})
            EXPECT_FALSE(FlatWater(frame, {1000, speed * Vec3::Unit(axis)}).bounds().still)
                << axis << " " << speed;
}

TEST(FlatWater, FlowsAlikeEverywhereInTheAxesOfItsFrame) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const WaterFrame frame = WaterFrame::fromUp(random.inCube(100), random.direction());
        const Vec3 flowWorld = random.inCube(3);
        const FlatWater water(frame, {1000, flowWorld});
        Eigen::ArrayX3d velocities = Eigen::ArrayX3d::Constant(5, 3, 99);
        water.sampleVelocity(randomPoints(5, random), random.uniform(0, 100), velocities);
        for (Eigen::Index row = 0; row < 5; ++row) {
            const Vec3 back = frame.worldFromFrame() * velocities.row(row).matrix().transpose();
            // There and back by two rotations of a vector shorter than 3 sqrt 3.
            EXPECT_TRUE(isNear(back, flowWorld, 50 * epsilon));
        }
    }
}

TEST(FlatWater, IsFreshUnlessADensityIsGiven) {
    EXPECT_EQ(FlatWater(WaterFrame::zUp()).density(), freshWaterDensity);
    EXPECT_EQ(FlatWater(WaterFrame::zUp(), {seaWaterDensity, Vec3::Zero()}).density(), seaWaterDensity);
}

TEST(FlatWater, KeepsItsFrame) {
    const WaterFrame frame = WaterFrame::fromUp({1, 2, 3}, {3, 2, 1});
    const FlatWater water(frame);
    EXPECT_EQ(water.frame().originWorld(), frame.originWorld());
    EXPECT_EQ(water.frame().worldFromFrame(), frame.worldFromFrame());
}

TEST(WaterPlaneInBody, GivesTheDepthThatPointsHaveInTheWorld) {
    Random random(4);
    for (double distance : {1.0, 1e3, 1e6})
        for (int i = 0; i < 1000; ++i) {
            const FlatWater water(WaterFrame::fromUp(random.inCube(distance), random.direction()));
            const Pose pose = randomPose(distance, random);
            const Vec3 inBody = random.inCube(1);
            const Vec3 inWorld = pose.position + pose.orientation * inBody;
            const double depth = -water.frame().upWorld().dot(inWorld - water.frame().originWorld());
            // Each side rounds some ten times numbers up to the distance between the points, 2 sqrt 3 of
            // `distance`.
            EXPECT_NEAR(waterPlaneInBody(water, pose, 0).depth(inBody), depth, 40 * epsilon * distance);
        }
}

TEST(WaterPlaneInBody, PointsUpByAUnitVectorInTheBodysAxes) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const FlatWater water(WaterFrame::fromUp(random.inCube(10), random.direction()));
        const Pose pose = randomPose(10, random);
        const Vec3 upInBody = waterPlaneInBody(water, pose, 0).upInBody;
        EXPECT_NEAR(upInBody.norm(), 1, 10 * epsilon);
        EXPECT_TRUE(isNear(pose.worldFromBody() * upInBody, water.frame().upWorld(), 10 * epsilon));
    }
}

TEST(WaterPlaneInBody, NearTheSurfaceLosesNothingByDistanceAlongIt) {
    // Bodies 10 km along the surface of water that is level with the world: their heights are exact, and stay
    // so.
    const FlatWater water(WaterFrame::yUp({0, 5, 0}));
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const double height = random.uniform(-1, 1);
        const Pose pose{{random.uniform(-1e4, 1e4), 5 + height, random.uniform(-1e4, 1e4)},
                        random.orientation()};
        EXPECT_EQ(waterPlaneInBody(water, pose, 0).heightOfWater, 5 - pose.position.y());
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
