#pragma once

#include <LinearMath/btTransform.h>

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy {

inline Vec3 toEigen(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}

inline btVector3 toBullet(const Vec3& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

/// The orientation is made a rotation to double precision: Bullet's single precision matrices are so only to
/// 1e-7, which would show as a horizontal force.
inline Pose toPose(const btTransform& transform) {
    Mat3 basis;
    for (int row = 0; row < 3; ++row)
        basis.row(row) = toEigen(transform.getBasis()[row]).transpose();
    return {toEigen(transform.getOrigin()), Eigen::Quaterniond(basis).normalized()};
}

inline btTransform toTransform(const Pose& pose) {
    const Eigen::Quaterniond& q = pose.orientation;
    return btTransform(btQuaternion(btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())),
                       toBullet(pose.position));
}

}  // namespace bullet_buoyancy
