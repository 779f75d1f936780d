#include "bullet_buoyancy/bullet/shared_hulls.h"

#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

namespace bullet_buoyancy::test {
namespace {

TEST(SharedHulls, AShapeIsReadOnceWhileItsHullIsThere) {
    SharedHulls hulls;
    const btBoxShape shape({1, 2, 3}), alike({1, 2, 3});
    const HullResult first = hulls.of(shape);
    ASSERT_TRUE(first.hull);
    EXPECT_EQ(hulls.of(shape).hull, first.hull);
    EXPECT_NE(hulls.of(alike).hull, first.hull);
}

TEST(SharedHulls, AScaledShapeIsReadAgain) {
    SharedHulls hulls;
    btBoxShape shape({1, 2, 3});
    const HullResult before = hulls.of(shape);
    shape.setLocalScaling({2, 2, 2});
    const HullResult after = hulls.of(shape);
    // Coordinates of single precision.
    EXPECT_NEAR(after.hull->moments.volume, 8 * before.hull->moments.volume,
                1e-5 * after.hull->moments.volume);
}

/// What was remarked of a shape is remarked of each body that has it.
TEST(SharedHulls, TheStatusIsSharedToo) {
    SharedHulls hulls;
    btCompoundShape shape;
    btBoxShape child({1, 1, 1});
    shape.addChildShape(btTransform::getIdentity(), &child);
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0.5, 0, 0)), &child);
    const HullResult first = hulls.of(shape), second = hulls.of(shape);
    ASSERT_GT(first.status.overlappingPairs, 0);
    EXPECT_EQ(second.status.overlappingPairs, first.status.overlappingPairs);
}

TEST(SharedHulls, ShapesThatAreGoneAreForgotten) {
    SharedHulls hulls;
    btBoxShape shape({1, 2, 3});
    std::weak_ptr<const Hull> gone = hulls.of(shape).hull;
    EXPECT_TRUE(gone.expired());
    EXPECT_TRUE(hulls.of(shape).hull);
}

TEST(SharedHulls, RefusedShapesAreRefusedEachTime) {
    SharedHulls hulls;
    const btStaticPlaneShape plane({0, 0, 1}, 0);
    EXPECT_FALSE(hulls.of(plane).hull);
    EXPECT_FALSE(hulls.of(plane).status.accepted());
}

}  // namespace
}  // namespace bullet_buoyancy::test
