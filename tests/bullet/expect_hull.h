#pragma once

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "bullet_buoyancy/core/constants.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

/// Shapes hold their dimensions as btScalar, rounded by 6e-8 or 1e-16 of them. Scaling and margins round a
/// few times more, and a volume multiplies three dimensions.
inline constexpr double shapeRounding = sizeof(btScalar) == 4 ? 2e-6 : 1e-13;

inline const btTransform identity = btTransform::getIdentity();

/// What a shape must displace and wet.
struct Solid {
    double volume;
    Vec3 centroid;
    double area;
};

inline Solid solidOf(const TriangleMesh& mesh) {
    const VolumeMoments moments = volumeMoments(mesh);
    return {moments.volume, moments.centroid(), surfaceArea(mesh)};
}

inline Solid boxSolid(const Vec3& halfExtents, const Vec3& centre = Vec3::Zero()) {
    return solidOf(boxMesh(2 * halfExtents, centre));
}

/// `tolerance` is relative. Returns the hull for more checks, an empty one if the shape was refused.
inline HullResult expectHull(const btCollisionShape& shape, const Solid& expected,
                             double tolerance = shapeRounding) {
    HullResult result = hullFromShape(shape);
    EXPECT_TRUE(result.status.accepted()) << result.status.describe();
    if (!result.hull) result.hull = std::make_shared<Hull>();
    const Hull& hull = *result.hull;
    EXPECT_NEAR(hull.moments.volume, expected.volume, tolerance * expected.volume);
    EXPECT_TRUE(isNear(hull.moments.centroid(), expected.centroid,
                       tolerance * (hull.bounds.radius + expected.centroid.norm())));
    EXPECT_NEAR(hull.surfaceArea, expected.area, tolerance * expected.area);
    EXPECT_TRUE(hull.meshIsClosed);
    EXPECT_EQ(result.status.openEdges, 0u);
    return result;
}

inline void expectRefused(const btCollisionShape& shape, HullError error) {
    const HullResult result = hullFromShape(shape);
    EXPECT_EQ(result.hull, nullptr);
    EXPECT_EQ(result.status.error, error) << result.status.describe();
}

inline double reach(const SolidOfRevolution& solid, const Vec3& direction) {
    const double along = solid.axis.dot(direction), across = (direction - along * solid.axis).norm();
    double farthest = -std::numeric_limits<double>::max();
    for (const ProfilePiece& piece : solid.profile)
        for (int i = 0; i <= 1000; ++i) {
            const double x = piece.begin + (piece.end - piece.begin) * (1 - std::cos(pi * i / 1000)) / 2;
            const double radius = std::sqrt(std::max(0.0, piece.radiusSquared(x)));
            farthest = std::max(farthest, solid.origin.dot(direction) + x * along + radius * across);
        }
    return farthest;
}

/// How far a hull extends from the origin along a unit vector.
inline double reach(const Hull& hull, const Vec3& direction) {
    double farthest = -std::numeric_limits<double>::max();
    for (const Vec3& vertex : hull.mesh.vertices)
        farthest = std::max(farthest, vertex.dot(direction));
    for (const Sphere& sphere : hull.spheres)
        farthest = std::max(farthest, sphere.centre.dot(direction) + sphere.radius);
    for (const SolidOfRevolution& solid : hull.solids)
        farthest = std::max(farthest, reach(solid, direction));
    return farthest;
}

/// The same by what Bullet collides with.
inline double bulletReach(const btCollisionShape& shape, const Vec3& direction, const btTransform& place) {
    if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        double farthest = -std::numeric_limits<double>::max();
        for (int i = 0; i < compound.getNumChildShapes(); ++i)
            farthest = std::max(farthest, bulletReach(*compound.getChildShape(i), direction,
                                                      place * compound.getChildTransform(i)));
        return farthest;
    }
    const auto& convex = static_cast<const btConvexShape&>(shape);
    return toEigen(place(convex.localGetSupportingVertex(toBullet(direction) * place.getBasis())))
        .dot(direction);
}

/// Checks position, orientation and extent. Margins of the shapes must be 0 where they are not part of the
/// shape.
inline void expectSameReachAsInBullet(const btCollisionShape& shape, double tolerance = 1e-5) {
    const HullResult result = hullFromShape(shape);
    ASSERT_TRUE(result.hull) << result.status.describe();
    Random random(1);
    // Profiles of round solids are sampled to (pi / 1000)^2 / 8 = 1e-6 of their size of a few m.
    for (int i = 0; i < 100; ++i) {
        const Vec3 direction = random.direction();
        EXPECT_NEAR(reach(*result.hull, direction), bulletReach(shape, direction, identity), tolerance)
            << shape.getName();
    }
}

}  // namespace bullet_buoyancy::test
