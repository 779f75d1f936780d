#pragma once

#include <gtest/gtest.h>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "support/known_solids.h"
#include "support/near.h"

namespace bullet_buoyancy::test {

/// Shapes hold their dimensions as btScalar, rounded by 6e-8 or 1e-16 of them. Scaling and margins round a
/// few times more, and a volume multiplies three dimensions.
inline constexpr double shapeRounding = sizeof(btScalar) == 4 ? 2e-6 : 1e-14;

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

/// `tolerance` is relative. Returns the hull, for more.
inline HullResult expectHull(const btCollisionShape& shape, const Solid& expected,
                             double tolerance = shapeRounding) {
    HullResult result = hullFromShape(shape);
    EXPECT_TRUE(result.status.accepted()) << result.status.describe();
    if (!result.hull) return result;
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

}  // namespace bullet_buoyancy::test
