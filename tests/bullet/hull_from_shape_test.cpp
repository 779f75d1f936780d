#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvex2dShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTetrahedronShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>

#include <limits>

#include "bullet/known_shapes.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

constexpr btScalar nan = std::numeric_limits<btScalar>::quiet_NaN();

TEST(HullFromBox, HasTheHalfExtentsThatBulletWasGiven) {
    const Vec3 halfExtents(0.3, 0.5, 0.7), scaling(2, 0.5, 3);
    for (double margin : {0.0, 0.04, 0.2}) {
        btBoxShape box(toBullet(halfExtents));
        box.setMargin(btScalar(margin));
        expectHull(box, boxSolid(halfExtents));
        box.setLocalScaling(toBullet(scaling));
        expectHull(box, boxSolid(halfExtents.cwiseProduct(scaling)));
        box.setMargin(btScalar(0.01));
        expectHull(box, boxSolid(halfExtents.cwiseProduct(scaling)));
    }
}

TEST(HullFromBox, HasEightVerticesAndTwelveTriangles) {
    const HullResult result = expectHull(btBoxShape({1, 2, 3}), boxSolid({1, 2, 3}));
    EXPECT_EQ(result.hull->mesh.vertices.size(), 8u);
    EXPECT_EQ(result.hull->mesh.triangles.size(), 12u);
}

TEST(HullFromPoints, TakesOnlyOuterPointsWithLocalScaling) {
    const Vec3 centre(1, -2, 3), half(0.5, 0.25, 0.75);
    std::vector<btVector3> points;
    Random random(2);
    for (int i = 0; i < 50; ++i)
        points.push_back(toBullet(centre + random.inCube(0.99).cwiseProduct(half)));
    for (const Vec3& corner : boxMesh(2 * half, centre).vertices)
        points.push_back(toBullet(corner));

    btConvexHullShape hull;
    for (const btVector3& point : points)
        hull.addPoint(point);
    btConvexPointCloudShape cloud(points.data(), int(points.size()), {1, 1, 1});
    for (const Vec3& scaling : {Vec3(1, 1, 1), Vec3(2, 0.5, 3), Vec3(-1, 1, 2)}) {
        const Solid expected = boxSolid(half.cwiseProduct(scaling).cwiseAbs(), centre.cwiseProduct(scaling));
        hull.setLocalScaling(toBullet(scaling));
        cloud.setLocalScaling(toBullet(scaling));
        for (const btCollisionShape* shape :
             {static_cast<btCollisionShape*>(&hull), static_cast<btCollisionShape*>(&cloud)}) {
            const HullResult result = expectHull(*shape, expected);
            EXPECT_EQ(result.hull->mesh.vertices.size(), 8u);
        }
    }
}

TEST(HullFromPoints, TakesATetrahedronAsItIs) {
    // Half the areas of three right angles and of the face between (1,0,0), (0,2,0) and (0,0,3).
    const double area = (2 + 6 + 3 + Vec3(6, 3, 2).norm()) / 2;
    expectHull(*tetrahedron(), {1, {0.25, 0.5, 0.75}, area});
}

TEST(HullFromUniformScaling, ScalesItsChild) {
    const auto cone = coneAlong(2, 0.3, 0.8), box = boxOf({0.3, 0.5, 0.7});
    const auto off = multiSphere({{{1, 2, 3}, 0.5}});
    expectHull(btUniformScalingShape(cone.get(), 2), coneSolid(0.6, 1.6, 2));
    Solid mirrored = coneSolid(0.6, 1.6, 2);
    mirrored.centroid = -mirrored.centroid;
    expectHull(btUniformScalingShape(cone.get(), -2), mirrored);
    expectHull(btUniformScalingShape(box.get(), btScalar(0.5)), boxSolid({0.15, 0.25, 0.35}));
    expectHull(btUniformScalingShape(off.get(), 2), {ballSolid(1).volume, {2, 4, 6}, ballSolid(1).area});
}

TEST(HullFromCompound, PlacesNestedChildren) {
    const Vec3 half(0.3, 0.5, 0.7);
    const auto box = boxOf(half), cone = coneAlong(0, 0.3, 0.8);
    box->setMargin(0);
    cone->setMargin(0);
    const btTransform placeOfBox(btQuaternion({1, 0, 0}, btScalar(0.4)), {0, 0, 2});
    const btTransform placeOfCone(btQuaternion({0, 0, 1}, 1), {0, -2, 0});
    const btTransform placeOfBoth(btQuaternion({0, 1, 0}, 2), {3, 2, 1});
    btCompoundShape inner, outer;
    inner.addChildShape(placeOfBox, box.get());
    inner.addChildShape(placeOfCone, cone.get());
    outer.addChildShape(placeOfBoth, &inner);

    const Solid first = boxSolid(half), second = coneSolid(0.3, 0.8, 0);
    const Vec3 firstCentre = toEigen((placeOfBoth * placeOfBox)(toBullet(first.centroid)));
    const Vec3 secondCentre = toEigen((placeOfBoth * placeOfCone)(toBullet(second.centroid)));
    const double volume = first.volume + second.volume;
    const HullResult result =
        expectHull(outer, {volume, (first.volume * firstCentre + second.volume * secondCentre) / volume,
                           first.area + second.area});
    EXPECT_EQ(result.status.overlappingPairs, 0u);
    expectSameReachAsInBullet(outer);
}

TEST(HullFromCompound, FollowsItsLocalScaling) {
    const auto box = boxOf({0.3, 0.5, 0.7}), ball = multiSphere({{Vec3::Zero(), 0.5}});
    box->setMargin(0);
    btCompoundShape compound;
    compound.addChildShape(btTransform(btQuaternion::getIdentity(), {0, 0, 2}), box.get());
    compound.addChildShape(btTransform(btQuaternion({0, 0, 1}, 1), {0, -2, 0}), ball.get());
    compound.setLocalScaling({2, 2, 2});
    const double boxVolume = 8 * 0.84, ballVolume = ballSolid(1).volume;
    expectHull(compound,
               {boxVolume + ballVolume,
                (boxVolume * Vec3(0, 0, 4) + ballVolume * Vec3(0, -4, 0)) / (boxVolume + ballVolume),
                boxSolid({0.6, 1, 1.4}).area + ballSolid(1).area});
    expectSameReachAsInBullet(compound);
}

/// A pile of unit cubes at multiples of `spacing` along a slanted axis.
struct PileOfCubes {
    btBoxShape cube{btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5))};
    btCompoundShape compound;

    PileOfCubes(int count, double spacing) {
        const btTransform pose(btQuaternion(btVector3(1, 2, 3).normalized(), btScalar(0.7)), {1, 2, 3});
        for (int i = 0; i < count; ++i)
            compound.addChildShape(
                pose * btTransform(btQuaternion::getIdentity(), {btScalar(spacing * i), 0, 0}), &cube);
    }
};

TEST(HullFromCompound, NotesHowMuchOverlaps) {
    const PileOfCubes pile(3, 0.75);
    const HullResult result = hullFromShape(pile.compound);
    ASSERT_TRUE(result.status.accepted());
    EXPECT_EQ(result.status.overlappingPairs, 2u);
    // Estimated to 1 % of the space that both bounding boxes cover: at most sqrt(27) m^3, of cubes on a
    // corner.
    EXPECT_NEAR(result.status.overlapVolume, 2 * 0.25, 2 * 0.052);
    EXPECT_NEAR(result.hull->moments.volume, 3, 3 * shapeRounding);
    EXPECT_NE(result.status.describe().find("overlap"), std::string::npos);
}

TEST(HullFromCompound, PartsThatTouchDoNotOverlap) {
    for (double spacing : {1.0, 1.25}) {
        const PileOfCubes pile(3, spacing);
        const HullStatus status = hullFromShape(pile.compound).status;
        EXPECT_EQ(status.overlappingPairs, 0u);
        EXPECT_EQ(status.describe(), "ok");
    }
}

TEST(HullFromCompound, IsRefusedForTheReasonOfAChild) {
    btBoxShape box({1, 1, 1});
    btStaticPlaneShape plane({0, 0, 1}, 0);
    btCompoundShape inner, outer, empty;
    inner.addChildShape(identity, &box);
    inner.addChildShape(identity, &plane);
    outer.addChildShape(identity, &inner);
    expectRefused(outer, HullError::unsupportedShape);
    EXPECT_NE(hullFromShape(outer).status.describe().find("plane"), std::string::npos);
    expectRefused(empty, HullError::noTriangles);
}

/// Of a type that Bullet does not make itself here.
class ShapeOfType : public btEmptyShape {
public:
    explicit ShapeOfType(int type) { m_shapeType = type; }
};

void expectUnsupported(const btCollisionShape& shape, const char* reason) {
    expectRefused(shape, HullError::unsupportedShape);
    const std::string text = hullFromShape(shape).status.describe();
    EXPECT_NE(text.find(reason), std::string::npos) << text;
}

TEST(HullFromShape, RefusesWhatCannotFloatAndSaysWhy) {
    expectUnsupported(btStaticPlaneShape({0, 0, 1}, 0), "plane");
    const std::vector<float> heights(9, 0.5f);
    expectUnsupported(btHeightfieldTerrainShape(3, 3, heights.data(), btScalar(0), btScalar(1), 2, false),
                      "heightfield");
    expectUnsupported(btEmptyShape(), "empty");
    expectUnsupported(btBox2dShape({1, 1, 1}), "2D");
    btBoxShape box({1, 1, 1});
    expectUnsupported(btConvex2dShape(&box), "2D");
    expectUnsupported(ShapeOfType(SOFTBODY_SHAPE_PROXYTYPE), "soft");
    for (int type : {CUSTOM_CONVEX_SHAPE_TYPE, CUSTOM_CONCAVE_SHAPE_TYPE, CUSTOM_POLYHEDRAL_SHAPE_TYPE,
                     INVALID_SHAPE_PROXYTYPE})
        expectUnsupported(ShapeOfType(type), "BodyDef");
}

TEST(HullFromShape, RefusesWhatIsNotFinite) {
    for (btScalar bad : {nan, std::numeric_limits<btScalar>::infinity()}) {
        expectRefused(btBoxShape({1, bad, 1}), HullError::notFinite);
        expectRefused(btSphereShape(bad), HullError::notFinite);
        expectRefused(btCapsuleShape(1, bad), HullError::notFinite);
        expectRefused(btCylinderShape({1, bad, 1}), HullError::notFinite);
        expectRefused(btConeShape(bad, 1), HullError::notFinite);
    }
    btSphereShape ball(1);
    btCompoundShape compound;
    compound.addChildShape(btTransform(btQuaternion::getIdentity(), {0, nan, 0}), &ball);
    expectRefused(compound, HullError::notFinite);
}

TEST(HullFromShape, RefusesWhatIsFlat) {
    expectRefused(btBoxShape({0, 0, 0}), HullError::flatPoints);
    expectRefused(btBoxShape({1, 0, 1}), HullError::flatPoints);
    expectRefused(btTriangleShape({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), HullError::flatPoints);
    expectRefused(btBU_Simplex1to4({0, 0, 0}, {1, 0, 0}), HullError::flatPoints);
    expectRefused(btSphereShape(0), HullError::noVolume);
    expectRefused(btCylinderShape({1, 0, 1}), HullError::noVolume);

    Random random(4);
    btConvexHullShape none, coplanar;
    for (int i = 0; i < 20; ++i)
        coplanar.addPoint(toBullet({random.uniform(-1, 1), random.uniform(-1, 1), 0.5}));
    expectRefused(none, HullError::flatPoints);
    expectRefused(coplanar, HullError::flatPoints);
}

}  // namespace
}  // namespace bullet_buoyancy::test
