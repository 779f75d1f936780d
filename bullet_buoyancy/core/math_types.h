#pragma once

#include <Eigen/Core>

namespace bullet_buoyancy {

// In double precision, whatever Bullet's.
using Vec2 = Eigen::Vector2d;              ///< x and y of a water frame
using Vec3 = Eigen::Vector3d;              ///< positions, directions, forces ...
using Mat3 = Eigen::Matrix3d;              ///< rotations, second moments
using Mat6 = Eigen::Matrix<double, 6, 6>;  ///< on pairs of a linear and an angular vector
using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< such a pair

}  // namespace bullet_buoyancy
