#include "bullet_buoyancy/bullet/shared_hulls.h"

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <new>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "bullet_buoyancy/water/flat_water.h"

namespace bullet_buoyancy::test {
namespace {

class Body : public btRigidBody {
public:
    explicit Body(btCollisionShape& shape)
        : btRigidBody(btRigidBodyConstructionInfo(1, nullptr, &shape, {1, 1, 1})) {}
};

/// A place in memory where one shape comes to lie after another.
class Place {
public:
    ~Place() { clear(); }

    btBoxShape& put(const btVector3& halfExtents) {
        clear();
        return *(m_shape = new (m_memory) btBoxShape(halfExtents));
    }

private:
    void clear() {
        if (m_shape) m_shape->~btBoxShape();
    }

    alignas(16) unsigned char m_memory[sizeof(btBoxShape)];
    btBoxShape* m_shape = nullptr;
};

constexpr double rounding = 1e-5;  // coordinates of single precision, and Bullet's margins on them

TEST(SharedHulls, AShapeIsReadOnceForTheBodiesThatHaveIt) {
    SharedHulls hulls;
    btBoxShape shape({1, 2, 3}), alike({1, 2, 3});
    const Body one(shape), another(shape), onItsOwn(alike);
    const HullResult first = hulls.of(one);
    ASSERT_TRUE(first.hull);
    EXPECT_EQ(hulls.of(another).hull, first.hull);
    EXPECT_NE(hulls.of(onItsOwn).hull, first.hull);
}

TEST(SharedHulls, AScaledShapeIsReadAgain) {
    SharedHulls hulls;
    btBoxShape shape({1, 2, 3});
    const Body one(shape), another(shape);
    const HullResult before = hulls.of(one);
    shape.setLocalScaling({2, 2, 2});
    const HullResult after = hulls.of(another);
    EXPECT_NEAR(after.hull->moments.volume, 8 * before.hull->moments.volume,
                rounding * after.hull->moments.volume);
}

/// What was remarked of a shape is remarked of each body that has it.
TEST(SharedHulls, TheStatusIsSharedToo) {
    SharedHulls hulls;
    btCompoundShape shape;
    btBoxShape child({1, 1, 1});
    shape.addChildShape(btTransform::getIdentity(), &child);
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0.5, 0, 0)), &child);
    const Body one(shape), another(shape);
    const HullResult first = hulls.of(one), second = hulls.of(another);
    ASSERT_GT(first.status.overlappingPairs, 0);
    EXPECT_EQ(second.status.overlappingPairs, first.status.overlappingPairs);
}

TEST(SharedHulls, ShapesWhoseBodiesAreGoneAreForgotten) {
    SharedHulls hulls;
    btBoxShape shape({1, 2, 3});
    const Body one(shape), another(shape);
    std::weak_ptr<const Hull> hull = hulls.of(one).hull;
    hulls.of(another);
    hulls.forget(one, &shape);
    EXPECT_FALSE(hull.expired());
    hulls.forget(another, &shape);
    EXPECT_TRUE(hull.expired());
    EXPECT_TRUE(hulls.of(one).hull);
}

TEST(SharedHulls, RefusedShapesAreRefusedEachTime) {
    SharedHulls hulls;
    btStaticPlaneShape plane({0, 0, 1}, 0);
    const Body body(plane);
    EXPECT_FALSE(hulls.of(body).hull);
    EXPECT_FALSE(hulls.of(body).status.accepted());
}

/// What has changed inside of a shape is not seen from outside.
TEST(SharedHulls, AnOutdatedHullIsReadAgainOnceForAll) {
    SharedHulls hulls;
    btCompoundShape shape;
    btBoxShape child({1, 1, 1});
    shape.addChildShape(btTransform::getIdentity(), &child);
    const Body one(shape), another(shape), third(shape);
    const auto before = hulls.of(one).hull;
    hulls.of(another);
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(5, 0, 0)), &child);
    const auto after = hulls.of(one, before.get()).hull;
    EXPECT_NEAR(after->moments.volume, 2 * before->moments.volume, rounding * after->moments.volume);
    EXPECT_EQ(hulls.of(another, before.get()).hull, after);
    EXPECT_EQ(hulls.of(third).hull, after);
}

TEST(SharedHulls, AnotherShapeAtTheSameAddressIsReadForItself) {
    SharedHulls hulls;
    Place place;
    btBoxShape elsewhere({1, 1, 1});
    btCollisionShape& small = place.put({1, 1, 1});
    Body one(small);
    const auto before = hulls.of(one).hull;
    one.setCollisionShape(&elsewhere);
    btCollisionShape& large = place.put({2, 2, 2});
    ASSERT_EQ(&large, &small);
    const Body another(large);
    EXPECT_NEAR(hulls.of(another).hull->moments.volume, 64, 64 * rounding);
}

/// The same through the action, whose body keeps its old hull.
TEST(SharedHulls, ABodyIsNotGivenTheHullOfAShapeThatWasDeleted) {
    const FlatWater water(WaterFrame::zUp());
    BuoyancyAction buoyancy(water);
    Place place;
    btBoxShape elsewhere({1, 1, 1});
    Body one(place.put({1, 1, 1}));
    ASSERT_TRUE(buoyancy.addBody(one));
    one.setCollisionShape(&elsewhere);
    Body another(place.put({2, 2, 2}));
    another.translate({0, 0, -100});
    ASSERT_TRUE(buoyancy.addBody(another));

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.addRigidBody(&another);
    world.addAction(&buoyancy);
    world.stepSimulation(btScalar(1) / 60, 0);
    EXPECT_NEAR(buoyancy.report(another).submergedVolume, 64, 64 * rounding);
    world.removeAction(&buoyancy);
    world.removeRigidBody(&another);
}

}  // namespace
}  // namespace bullet_buoyancy::test
