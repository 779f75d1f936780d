#pragma once

#include <vector>

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// Where a particle of the surface of trochoidal waves is, and the derivatives of that by where it rests.
struct Trochoid {
    Vec2 rest = Vec2::Zero();      ///< m
    Vec2 shift = Vec2::Zero();     ///< from the wanted place to where the particle is, m
    double elevation = 0;          ///< m
    Vec2 gradient = Vec2::Zero();  ///< of the elevation by `rest`
    /// Sum of amplitude k k^T / |k| cos(theta), its entries xx, xy, yy: the place changes by the unit matrix
    /// less this. It is less than the waves' steepness.
    Vec3 squeeze = Vec3::Zero();
    /// Sum of amplitude k k^T k / |k| sin(theta), its entries xxx, xxy, xyy, yyy: second derivatives of the
    /// place, 1/m.
    Eigen::Vector4d bend = Eigen::Vector4d::Zero();

    /// Slopes of the surface.
    Vec2 slope() const;

    /// Inverse of the place's derivative by `rest`.
    Eigen::Matrix2d restFromPlace() const;
};

/// The particle that rests at `rest`, seen from `place`.
Trochoid trochoidAt(const std::vector<WaveLanes>& waves, double time, const Vec2& rest, const Vec2& place);

/// The particle which is at `place`, to 1e-10 m. The waves' steepness must be below 1: then there is exactly
/// one, for the derivative of the place is symmetric and positive definite.
Trochoid findTrochoid(const std::vector<WaveLanes>& waves, double time, const Vec2& place);

}  // namespace bullet_buoyancy
