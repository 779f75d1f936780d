#pragma once

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// Where a particle of the surface of trochoidal waves is, and the derivatives of that by where it rests.
/// Symmetric ones have the entries xx, xy, yy, or xxx, xxy, xyy, yyy, and so on.
struct Trochoid {
    Vec2 rest = Vec2::Zero();      ///< m
    Vec2 shift = Vec2::Zero();     ///< from the wanted place to where the particle is, m
    double elevation = 0;          ///< m
    Vec2 gradient = Vec2::Zero();  ///< of the elevation by `rest`
    Vec3 sag = Vec3::Zero();       ///< second derivatives of the elevation by `rest`, times -1, 1/m
    /// The place changes by the unit matrix less this, which is less than the waves' steepness.
    Vec3 squeeze = Vec3::Zero();
    Eigen::Vector4d bend = Eigen::Vector4d::Zero();  ///< second derivatives of the place by `rest`, 1/m

    Eigen::Vector4d sagFalls = Eigen::Vector4d::Zero();  ///< minus those of `sag`, 1/m^2
    Eigen::Matrix<double, 5, 1> bendRises = Eigen::Matrix<double, 5, 1>::Zero();  ///< those of `bend`, 1/m^2

    /// Slopes of the surface.
    Vec2 slope() const;
};

/// Of the elevation, by the place.
struct SurfaceBend {
    Vec2 slope;
    Vec3 second;   ///< derivatives, 1/m
    double third;  ///< upper bound of the third one along any direction, 1/m^2
};

SurfaceBend surfaceBend(const Trochoid& at);

/// The particle which is at `place`. The waves' steepness must be below 1: then there is exactly one, for the
/// derivative of the place is symmetric and positive definite.
///
/// It is not looked at again if it is nearer than `reach` (m) to one that was: from there on that one's
/// derivatives tell, the highest taken over unchanged.
Trochoid findTrochoid(const WavesAtTime& waves, const Vec2& place, double reach);

/// The same with third derivatives by `rest`: `sagFalls` and `bendRises`, which are zero else.
Trochoid findBentTrochoid(const WavesAtTime& waves, const Vec2& place, double reach);

}  // namespace bullet_buoyancy
