#pragma once

#include <LinearMath/btTransform.h>

#include <cmath>

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy {

/// In double precision, without loss.
inline Vec3 toEigen(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}

/// Rounded to btScalar.
inline btVector3 toBullet(const Vec3& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

/// The orientation is made a rotation to double precision: Bullet's single precision matrices are so only to
/// 1e-7, which would show as a horizontal force.
inline Pose toPose(const btTransform& transform) {
    Mat3 basis;
    for (int row = 0; row < 3; ++row)
        basis.row(row) = toEigen(transform.getBasis()[row]).transpose();
    Eigen::Quaterniond orientation(basis);
    const double excess = orientation.squaredNorm() - 1;
    constexpr double seriesEnds = 1e-5;  // beyond, its terms that are left out pass rounding
    orientation.coeffs() *=
        std::abs(excess) < seriesEnds ? 1 - excess * (0.5 - excess * 0.375) : 1 / std::sqrt(1 + excess);
    return {toEigen(transform.getOrigin()), orientation};
}

/// Rounded to btScalar.
inline btTransform toTransform(const Pose& pose) {
    const Eigen::Quaterniond& q = pose.orientation;
    return btTransform(btQuaternion(btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())),
                       toBullet(pose.position));
}

}  // namespace bullet_buoyancy
