#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "support/known_solids.h"
#include "support/worst_difference.h"

namespace bullet_buoyancy::test {
namespace {

/// Both evaluators round some hundred operations in double precision; the quadrature along the axis of solids
/// is promised to 1e-8. The hull of either is the one that was read, in whatever precision Bullet has it.
constexpr double roundingOfPolyhedra = 1e-12;
constexpr double quadratureOfSolids = 1e-8;

btVector3 vector(double x, double y, double z) {
    return toBullet({x, y, z});
}

void expectAgreement(const btCollisionShape& shape, double tolerance) {
    const HullResult result = hullFromShape(shape);
    ASSERT_TRUE(result.hull) << result.status.describe();
    const FlatWater water(WaterFrame::yUp());
    const WorstDifference worst = worstDifference(*result.hull, water, Vec3::Zero(), posesAHull());
    EXPECT_LT(worst.pressure, tolerance) << shape.getName();
}

std::unique_ptr<btTriangleMesh> triangleMesh(const TriangleMesh& mesh) {
    auto triangles = std::make_unique<btTriangleMesh>();
    for (const Triangle& t : mesh.triangles)
        triangles->addTriangle(toBullet(mesh.vertices[t[0]]), toBullet(mesh.vertices[t[1]]),
                               toBullet(mesh.vertices[t[2]]));
    return triangles;
}

class ShapesAgainstReferenceMesh : public testing::Test {
protected:
    std::unique_ptr<btTriangleMesh> m_ring = triangleMesh(ringMesh(0.3, 0.6, 0.2, 12));
};

TEST(ShapesAgainstReference, Box) {
    expectAgreement(btBoxShape(vector(0.5, 0.4, 0.3)), roundingOfPolyhedra);
}

TEST(ShapesAgainstReference, ConvexHullAndPointCloud) {
    std::vector<btVector3> points;
    for (const Vec3& vertex : wigleyMesh(1, 0.3, 0.2, 6, 4).vertices)
        points.push_back(toBullet(vertex));
    btConvexHullShape hull;
    for (const btVector3& point : points)
        hull.addPoint(point);
    expectAgreement(hull, roundingOfPolyhedra);
    expectAgreement(btConvexPointCloudShape(points.data(), int(points.size()), vector(1, 2, 1)),
                    roundingOfPolyhedra);
}

TEST_F(ShapesAgainstReferenceMesh, ConvexTriangleMesh) {
    const auto box = triangleMesh(boxMesh({1, 0.5, 0.4}));
    expectAgreement(btConvexTriangleMeshShape(box.get()), roundingOfPolyhedra);
}

TEST_F(ShapesAgainstReferenceMesh, BvhTriangleMeshAndItsScaledForm) {
    btBvhTriangleMeshShape mesh(m_ring.get(), true);
    expectAgreement(mesh, roundingOfPolyhedra);
    expectAgreement(btScaledBvhTriangleMeshShape(&mesh, vector(2, 1, 0.5)), roundingOfPolyhedra);
}

TEST_F(ShapesAgainstReferenceMesh, GImpactMesh) {
    btGImpactMeshShape mesh(m_ring.get());
    mesh.setLocalScaling(vector(1, 1.5, 1));
    mesh.updateBound();
    expectAgreement(mesh, roundingOfPolyhedra);
}

TEST(ShapesAgainstReference, Sphere) {
    expectAgreement(btSphereShape(btScalar(0.5)), quadratureOfSolids);
}

TEST(ShapesAgainstReference, Capsules) {
    expectAgreement(btCapsuleShapeX(btScalar(0.3), btScalar(0.8)), quadratureOfSolids);
    expectAgreement(btCapsuleShape(btScalar(0.3), btScalar(0.8)), quadratureOfSolids);
    expectAgreement(btCapsuleShapeZ(btScalar(0.3), btScalar(0.8)), quadratureOfSolids);
}

TEST(ShapesAgainstReference, Cylinders) {
    expectAgreement(btCylinderShapeX(vector(0.5, 0.3, 0.3)), quadratureOfSolids);
    expectAgreement(btCylinderShape(vector(0.3, 0.5, 0.3)), quadratureOfSolids);
    expectAgreement(btCylinderShapeZ(vector(0.3, 0.3, 0.5)), quadratureOfSolids);
}

TEST(ShapesAgainstReference, Cones) {
    expectAgreement(btConeShapeX(btScalar(0.4), 1), quadratureOfSolids);
    expectAgreement(btConeShape(btScalar(0.4), 1), quadratureOfSolids);
    expectAgreement(btConeShapeZ(btScalar(0.4), 1), quadratureOfSolids);
}

TEST(ShapesAgainstReference, MultiSphereOfTwo) {
    const btVector3 centres[] = {vector(-0.3, 0, 0.1), vector(0.4, 0.2, 0)};
    const btScalar radii[] = {btScalar(0.3), btScalar(0.2)};
    expectAgreement(btMultiSphereShape(centres, radii, 2), quadratureOfSolids);
}

TEST(ShapesAgainstReference, MinkowskiSum) {
    const btBoxShape box(vector(0.3, 0.2, 0.1)), other(vector(0.1, 0.2, 0.3));
    btMinkowskiSumShape sum(&box, &other);
    btTransform turned(btQuaternion(vector(1, 2, 3).normalized(), btScalar(0.7)), vector(0.1, 0, 0));
    sum.setTransformB(turned);
    expectAgreement(sum, roundingOfPolyhedra);
}

TEST(ShapesAgainstReference, CompoundAndUniformScaling) {
    btBoxShape box(vector(0.3, 0.2, 0.1));
    btCylinderShape barrel(vector(0.2, 0.3, 0.2));
    btUniformScalingShape half(&box, btScalar(0.5));
    btCompoundShape inner, outer;
    inner.addChildShape(
        btTransform(btQuaternion(vector(1, 2, 3).normalized(), btScalar(0.7)), vector(0.3, 0, 0)), &box);
    inner.addChildShape(btTransform(btQuaternion::getIdentity(), vector(-0.5, 0, 0)), &barrel);
    outer.addChildShape(btTransform(btQuaternion(vector(0, 1, 1).normalized(), 2), vector(0, 0.2, 0)),
                        &inner);
    outer.addChildShape(btTransform(btQuaternion::getIdentity(), vector(0, 0, 0.9)), &half);
    expectAgreement(outer, quadratureOfSolids);
}

}  // namespace
}  // namespace bullet_buoyancy::test
