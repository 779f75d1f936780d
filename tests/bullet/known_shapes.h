#pragma once

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btTetrahedronShape.h>

#include <cmath>
#include <memory>

#include "bullet/expect_hull.h"
#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy::test {

inline std::unique_ptr<btConvexInternalShape> boxOf(const Vec3& halfExtents) {
    return std::make_unique<btBoxShape>(toBullet(halfExtents));
}

inline std::unique_ptr<btConvexInternalShape> capsuleAlong(int axis, double radius, double height) {
    const auto r = btScalar(radius), h = btScalar(height);
    if (axis == 0) return std::make_unique<btCapsuleShapeX>(r, h);
    if (axis == 2) return std::make_unique<btCapsuleShapeZ>(r, h);
    return std::make_unique<btCapsuleShape>(r, h);
}

inline std::unique_ptr<btConvexInternalShape> cylinderAlong(int axis, double radius, double height) {
    Vec3 halfExtents = Vec3::Constant(radius);
    halfExtents[axis] = height / 2;
    if (axis == 0) return std::make_unique<btCylinderShapeX>(toBullet(halfExtents));
    if (axis == 2) return std::make_unique<btCylinderShapeZ>(toBullet(halfExtents));
    return std::make_unique<btCylinderShape>(toBullet(halfExtents));
}

inline std::unique_ptr<btConvexInternalShape> coneAlong(int axis, double radius, double height) {
    const auto r = btScalar(radius), h = btScalar(height);
    if (axis == 0) return std::make_unique<btConeShapeX>(r, h);
    if (axis == 2) return std::make_unique<btConeShapeZ>(r, h);
    return std::make_unique<btConeShape>(r, h);
}

inline std::unique_ptr<btConvexInternalShape> multiSphere(const std::vector<Sphere>& spheres) {
    std::vector<btVector3> centres;
    std::vector<btScalar> radii;
    for (const Sphere& sphere : spheres) {
        centres.push_back(toBullet(sphere.centre));
        radii.push_back(btScalar(sphere.radius));
    }
    return std::make_unique<btMultiSphereShape>(centres.data(), radii.data(), int(radii.size()));
}

inline std::unique_ptr<btConvexInternalShape> tetrahedron() {
    return std::make_unique<btBU_Simplex1to4>(btVector3(0, 0, 0), btVector3(1, 0, 0), btVector3(0, 2, 0),
                                              btVector3(0, 0, 3));
}

inline Solid ballSolid(double r) {
    return {4 * pi / 3 * r * r * r, Vec3::Zero(), 4 * pi * r * r};
}

inline Solid capsuleSolid(double r, double h) {
    return {pi * r * r * h + ballSolid(r).volume, Vec3::Zero(), 2 * pi * r * h + ballSolid(r).area};
}

inline Solid cylinderSolid(double r, double h) {
    return {pi * r * r * h, Vec3::Zero(), 2 * pi * r * (r + h)};
}

/// Its centroid is a quarter of the height above the base, the origin half way up.
inline Solid coneSolid(double r, double h, int axis) {
    return {pi * r * r * h / 3, -h / 4 * Vec3::Unit(axis), pi * r * (r + std::hypot(r, h))};
}

}  // namespace bullet_buoyancy::test
