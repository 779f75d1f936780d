#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <algorithm>
#include <limits>

#include "bullet/known_shapes.h"

namespace bullet_buoyancy::test {
namespace {

/// The cone between the circles where it touches both spheres, and what is left of the spheres beyond. Sphere
/// a is about the origin, sphere b at `distance` along `axis`.
Solid taperedCapsuleSolid(double a, double b, double distance, const Vec3& axis) {
    const double sine = (a - b) / distance, cosine = std::sqrt(1 - sine * sine);
    const double top = a * cosine, bottom = b * cosine, length = distance * cosine * cosine;
    const double sum = top * top + top * bottom + bottom * bottom;
    const double frustum = pi * length / 3 * sum;
    const double frustumCentre =
        a * sine + length * (top * top + 2 * top * bottom + 3 * bottom * bottom) / (4 * sum);
    const auto cap = [](double r, double height) { return pi * height * height * (3 * r - height) / 3; };
    const auto capCentre = [](double r, double height) {
        return 3 * (2 * r - height) * (2 * r - height) / (4 * (3 * r - height));
    };
    const double heightA = a * (1 + sine), heightB = b * (1 - sine);
    const double capA = cap(a, heightA), capB = cap(b, heightB), volume = frustum + capA + capB;
    const double moment =
        frustum * frustumCentre - capA * capCentre(a, heightA) + capB * (distance + capCentre(b, heightB));
    const double area =
        2 * pi * (a * heightA + b * heightB) + pi * (top + bottom) * std::hypot(length, top - bottom);
    return {volume, moment / volume * axis, area};
}

TEST(HullFromRoundShape, HasTheVolumeCentroidAndAreaOfTheSolid) {
    expectHull(btSphereShape(btScalar(0.7)), ballSolid(0.7));
    for (int axis : {0, 1, 2}) {
        SCOPED_TRACE(axis);
        expectHull(*capsuleAlong(axis, 0.3, 0.8), capsuleSolid(0.3, 0.8));
        expectHull(*cylinderAlong(axis, 0.3, 0.8), cylinderSolid(0.3, 0.8));
        expectHull(*coneAlong(axis, 0.3, 0.8), coneSolid(0.3, 0.8, axis));
    }
}

TEST(HullFromRoundShape, FollowsLocalScalingAsBulletDoes) {
    const Vec3 scaling(2, 0.5, 3);
    btSphereShape ball(btScalar(0.7));
    ball.setLocalScaling(toBullet(scaling));
    expectHull(ball, ballSolid(0.7 * scaling.x()));
    for (int axis : {0, 1, 2}) {
        SCOPED_TRACE(axis);
        // Bullet scales the radius of a capsule by the axis before its own, of a cylinder by the first other
        // one, of a cone by the mean of both.
        const int before = (axis + 2) % 3, after = (axis + 1) % 3, first = axis == 0 ? 1 : 0;
        const double height = 0.8 * scaling[axis], meanScaling = (scaling[before] + scaling[after]) / 2;
        const auto scaled = [&](std::unique_ptr<btConvexInternalShape> shape) {
            shape->setLocalScaling(toBullet(scaling));
            return shape;
        };
        expectHull(*scaled(capsuleAlong(axis, 0.3, 0.8)), capsuleSolid(0.3 * scaling[before], height));
        expectHull(*scaled(cylinderAlong(axis, 0.3, 0.8)), cylinderSolid(0.3 * scaling[first], height));
        expectHull(*scaled(coneAlong(axis, 0.3, 0.8)), coneSolid(0.3 * meanScaling, height, axis));
    }
}

TEST(HullFromRoundShape, MayBeMirrored) {
    for (int axis : {0, 1, 2}) {
        SCOPED_TRACE(axis);
        const auto cone = coneAlong(axis, 0.3, 0.8);
        cone->setLocalScaling({-1, -1, -1});
        Solid mirrored = coneSolid(0.3, 0.8, axis);
        mirrored.centroid = -mirrored.centroid;
        expectHull(*cone, mirrored);
        expectHull(*capsuleAlong(axis, -0.3, -0.8), capsuleSolid(0.3, 0.8));
    }
    expectHull(btSphereShape(btScalar(-0.7)), ballSolid(0.7));
}

TEST(HullFromRoundShape, IsNotChangedByMargins) {
    for (double margin : {0.0, 0.1}) {
        const auto cylinder = cylinderAlong(1, 0.3, 0.8), cone = coneAlong(1, 0.3, 0.8),
                   capsule = capsuleAlong(1, 0.3, 0.8);
        for (btConvexInternalShape* shape : {cylinder.get(), cone.get(), capsule.get()})
            shape->setMargin(btScalar(margin));
        expectHull(*cylinder, cylinderSolid(0.3, 0.8));
        expectHull(*cone, coneSolid(0.3, 0.8, 1));
        expectHull(*capsule, capsuleSolid(0.3, 0.8));
    }
}

TEST(HullFromRoundShape, ACapsuleWithoutHeightIsABall) {
    for (int axis : {0, 1, 2})
        expectHull(*capsuleAlong(axis, 0.3, 0), ballSolid(0.3));
}

TEST(HullFromConvexShape, ReachesAsFarAsInBulletAndIsBounded) {
    std::vector<std::unique_ptr<btConvexInternalShape>> shapes;
    shapes.push_back(std::make_unique<btSphereShape>(btScalar(0.7)));
    for (int axis : {0, 1, 2}) {
        shapes.push_back(capsuleAlong(axis, 0.3, 0.8));
        shapes.push_back(cylinderAlong(axis, 0.3, 0.8));
        shapes.push_back(coneAlong(axis, 0.3, 0.8));
        for (std::size_t i = shapes.size() - 3; i < shapes.size(); ++i)
            shapes[i]->setLocalScaling({btScalar(1.5), 1, 2});
    }
    shapes.push_back(boxOf({0.3, 0.5, 0.7}));
    shapes.push_back(tetrahedron());
    shapes.push_back(multiSphere({{{1, 0, 0.5}, 0.3}}));
    shapes.push_back(multiSphere({{{1, 0, 0.5}, 0.3}, {{0.2, 0.4, 0}, 0.5}}));
    for (const auto& shape : shapes) {
        shape->setMargin(0);
        shape->setLocalScaling(btVector3(shape->getLocalScaling()));  // updates cached bounding boxes
        expectSameReachAsInBullet(*shape);
        btVector3 low, high;
        shape->getAabb(identity, low, high);
        const Sphere bounds = hullFromShape(*shape).hull->bounds;
        const Vec3 all = Vec3::Constant(bounds.radius + 1e-6);
        EXPECT_TRUE(((bounds.centre - all).array() <= toEigen(low).array()).all()) << shape->getName();
        EXPECT_TRUE(((bounds.centre + all).array() >= toEigen(high).array()).all()) << shape->getName();
        EXPECT_LT(bounds.radius, toEigen(high - low).norm()) << shape->getName();
    }
}

TEST(HullFromMultiSphere, OfOneIsABall) {
    const auto shape = multiSphere({{{1, 2, 3}, 0.5}});
    expectHull(*shape, {ballSolid(0.5).volume, {1, 2, 3}, ballSolid(0.5).area});
    shape->setLocalScaling({2, 2, 2});
    expectHull(*shape, {ballSolid(1).volume, {2, 4, 6}, ballSolid(1).area});
}

TEST(HullFromMultiSphere, OfTwoIsATaperedCapsule) {
    const Vec3 axis = Vec3(2, -1, 2) / 3;
    for (double other : {0.5, 0.3, 0.05, 0.8}) {
        const auto shape = multiSphere({{Vec3::Zero(), 0.5}, {1.25 * axis, other}});
        const HullResult result = expectHull(*shape, taperedCapsuleSolid(0.5, other, 1.25, axis));
        EXPECT_EQ(result.status.tessellationError, 0);
    }
}

TEST(HullFromMultiSphere, OfTwoOneInsideTheOtherIsTheLargerBall) {
    const Vec3 offset(0.1, 0.2, -0.1);
    expectHull(*multiSphere({{Vec3::Zero(), 0.5}, {offset, 0.2}}), ballSolid(0.5));
    expectHull(*multiSphere({{offset, 0.2}, {Vec3::Zero(), 0.5}}), ballSolid(0.5));
    expectHull(*multiSphere({{Vec3::Zero(), 0.5}, {Vec3::Zero(), 0.5}}), ballSolid(0.5));
}

TEST(HullFromMultiSphere, OfTwoThatTouchFromInsideIsTheLargerBall) {
    // By rounding, one side or the other of the point where the common cone degenerates.
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double larger = 0.5, smaller = random.uniform(0.05, 0.45);
        const Vec3 centre = (larger - smaller) * random.direction();
        // Standing out by 1e-7 of the size adds less than that, squared.
        expectHull(*multiSphere({{Vec3::Zero(), larger}, {centre, smaller}}), ballSolid(larger),
                   shapeRounding);
    }
}

TEST(HullFromMultiSphere, OfThreeInALineIsTheirTaperedCapsuleToItsTessellation) {
    const Vec3 axis(0.6, 0, 0.8);
    const auto shape = multiSphere({{Vec3::Zero(), 0.5}, {0.6 * axis, 0.35}, {1.25 * axis, 0.3}});
    const double error = hullFromShape(*shape).status.tessellationError;
    // 5,120 triangles: edges of about 0.07 radians, whose chords fall short by a quarter of their square.
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 0.005);
    expectHull(*shape, taperedCapsuleSolid(0.5, 0.3, 1.25, axis), error);
}

TEST(HullFromMultiSphere, ScaledUnevenlyIsAnEllipsoid) {
    const auto shape = multiSphere({{{0.5, 0, -0.5}, 0.5}});
    shape->setLocalScaling({2, btScalar(0.5), 1});
    const HullResult result = hullFromShape(*shape);
    ASSERT_TRUE(result.hull);
    // The tessellated ball has the volume of the ball, and any scaling keeps their ratio.
    const double volume = 4 * pi / 3 * 1 * 0.25 * 0.5;
    EXPECT_NEAR(result.hull->moments.volume, volume, 1e-9 * volume);
    EXPECT_TRUE(isNear(result.hull->moments.centroid(), Vec3(1, 0, -0.5), 1e-9));
    const Vec3 tips(1 + 1, 0.25, 0.5 - 0.5);
    for (int axis : {0, 1, 2})
        EXPECT_NEAR(reach(*result.hull, Vec3::Unit(axis)), tips[axis], result.status.tessellationError);
}

TEST(HullFromMultiSphere, IsRefusedIfAnySphereIsNotFinite) {
    const double bad = std::numeric_limits<double>::quiet_NaN();
    const Sphere good{Vec3::Zero(), 0.5};
    for (const Sphere& lost : {Sphere{{bad, 0, 0}, 0.1}, Sphere{{1, 0, 0}, bad}}) {
        expectRefused(*multiSphere({lost}), HullError::notFinite);
        expectRefused(*multiSphere({lost, good}), HullError::notFinite);
        expectRefused(*multiSphere({good, lost}), HullError::notFinite);
        expectRefused(*multiSphere({good, good, lost}), HullError::notFinite);
    }
}

/// The sum of two boxes is spanned by the edges e of both: its volume is that of all the parallelepipeds, its
/// area twice that of all the parallelograms of them.
Solid sumOfBoxes(const Vec3& halfA, const Mat3& turnA, const Vec3& halfB, const Mat3& turnB,
                 const Vec3& centre) {
    Eigen::Matrix<double, 3, 6> edges;
    edges << turnA * (2 * halfA).asDiagonal().toDenseMatrix(),
        turnB * (2 * halfB).asDiagonal().toDenseMatrix();
    Solid sum{0, centre, 0};
    for (int i = 0; i < 6; ++i)
        for (int j = i + 1; j < 6; ++j) {
            const Vec3 ei = edges.col(i), ej = edges.col(j), normal = ei.cross(ej);
            sum.area += 2 * normal.norm();
            for (int k = j + 1; k < 6; ++k)
                sum.volume += std::abs(normal.dot(edges.col(k)));
        }
    return sum;
}

TEST(HullFromMinkowskiSum, OfTwoBoxesIsExact) {
    const Vec3 halfA(0.3, 0.5, 0.7), halfB(0.2, 0.1, 0.4);
    const auto a = boxOf(halfA), b = boxOf(halfB);
    btMinkowskiSumShape sum(a.get(), b.get());
    expectHull(sum, boxSolid(halfA + halfB));
    const btQuaternion turnA({0, 0, 1}, btScalar(0.5)), turnB(btVector3(1, 2, 3).normalized(), 1);
    const btTransform poseA(turnA, {1, 2, 3}), poseB(turnB, {btScalar(0.5), 0, -1});
    sum.setTransformA(poseA);
    sum.setTransformB(poseB);
    const HullResult result =
        expectHull(sum, sumOfBoxes(halfA, toPose(poseA).worldFromBody(), halfB, toPose(poseB).worldFromBody(),
                                   Vec3(1, 2, 3) - Vec3(0.5, 0, -1)));
    EXPECT_EQ(result.status.tessellationError, 0);
}

TEST(HullFromMinkowskiSum, OfATetrahedronWithItselfIsItsDifferenceBody) {
    // Rogers and Shephard (1957): 20 times the volume of a simplex, about the origin. Were it the sum: 8
    // times.
    const auto a = tetrahedron();
    const HullResult result = hullFromShape(btMinkowskiSumShape(a.get(), a.get()));
    ASSERT_TRUE(result.hull);
    EXPECT_NEAR(result.hull->moments.volume, 20, 20 * shapeRounding);
    EXPECT_TRUE(isNear(result.hull->moments.firstMoment, Vec3::Zero(), 20 * shapeRounding));
}

TEST(HullFromMinkowskiSum, OfABoxAndABallFollowsSteiner) {
    const double a = 0.6, b = 1, c = 1.4, r = 0.3;
    const auto box = boxOf(Vec3(a, b, c) / 2);
    btSphereShape ball{btScalar(r)};
    btMinkowskiSumShape sum(box.get(), &ball);
    sum.setTransformB(btTransform(btQuaternion::getIdentity(), {1, 0, 0}));
    // A slab on each face, a quarter of a cylinder on each edge, an eighth of the ball on each corner.
    const double faces = 2 * (a * b + b * c + c * a), edges = a + b + c;
    const Solid expected{a * b * c + faces * r + pi * r * r * edges + ballSolid(r).volume, Vec3(-1, 0, 0),
                         faces + 2 * pi * r * edges + ballSolid(r).area};
    const double error = hullFromShape(sum).status.tessellationError;
    // 1,280 triangles: edges of about 0.14 radians.
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 0.02);
    expectHull(sum, expected, error);
}

TEST(HullFromMinkowskiSum, OfABoxAndACylinderIsARoundedSlab) {
    const double a = 0.6, b = 1, c = 1.4, r = 0.3, h = 0.5;
    const auto box = boxOf(Vec3(a, b, c) / 2), cylinder = cylinderAlong(2, r, h);
    const btMinkowskiSumShape sum(box.get(), cylinder.get());
    const double slab = a * b + 2 * (a + b) * r + pi * r * r, rim = 2 * (a + b) + 2 * pi * r;
    const double error = hullFromShape(sum).status.tessellationError;
    expectHull(sum, {slab * (c + h), Vec3::Zero(), 2 * slab + rim * (c + h)}, error);
}

TEST(HullFromMinkowskiSum, ReachesAsFarAsInBullet) {
    const auto a = tetrahedron(), b = boxOf({0.3, 0.1, 0.2});
    a->setMargin(0);
    b->setMargin(0);
    btMinkowskiSumShape sum(a.get(), b.get());
    sum.setTransformA(btTransform(btQuaternion({0, 1, 0}, 1), {1, 0, 0}));
    sum.setTransformB(btTransform(btQuaternion({0, 0, 1}, 1), {0, 1, 2}));
    expectSameReachAsInBullet(sum, 10 * shapeRounding);
}

}  // namespace
}  // namespace bullet_buoyancy::test
