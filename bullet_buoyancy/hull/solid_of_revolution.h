#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bullet_buoyancy/hull/sphere.h"

namespace bullet_buoyancy {

/// A stretch of a solid's axis over which the squared radius is a quadratic of the axial coordinate:
/// cylinder, cone and zone of a sphere alike.
struct ProfilePiece {
    double begin;  ///< axial coordinate, m
    double end;    ///< likewise, above `begin`
    double c0;     ///< radius^2 = c0 + c1 x + c2 x^2, m^2
    double c1;     ///< m
    double c2;     ///< 1: -1 of a sphere, 0 of a cylinder, above 0 of a cone

    /// At the axial coordinate x (m), m^2.
    double radiusSquared(double x) const { return c0 + x * (c1 + x * c2); }

    /// r ds/dx with s the arc length of the profile, m: sqrt(r^2 + (r dr/dx)^2), smooth even where r goes to
    /// 0.
    double radiusTimesArcLength(double x) const {
        const double halfSlope = c1 / 2 + x * c2;
        return std::sqrt(std::max(0.0, radiusSquared(x) + halfSlope * halfSlope));
    }
};

/// Integrals of radius^2 and of x radius^2 over a stretch of a piece, m^3 and m^4.
struct RadiusMoments {
    double zeroth;  ///< m^3: the volume over pi
    double first;   ///< m^4
};

/// About the middle of the stretch, where the large coefficients of a steep cone do not cancel.
inline RadiusMoments radiusMoments(const ProfilePiece& piece, double from, double to) {
    const double middle = (from + to) / 2, half = (to - from) / 2, cubes = 2 * half * half * half / 3;
    const double zeroth = 2 * half * piece.radiusSquared(middle) + cubes * piece.c2;
    return {zeroth, middle * zeroth + cubes * (piece.c1 + 2 * middle * piece.c2)};
}

/// A closed solid with circular sections about an axis. Pieces follow one another along the axis, meet with
/// equal radii, and end in flat discs or in points.
struct SolidOfRevolution {
    Vec3 origin = Vec3::Zero();         ///< point of the axis where the axial coordinate is 0, body frame, m
    Vec3 axis = Vec3::UnitX();          ///< unit length, body frame
    std::vector<ProfilePiece> profile;  ///< along the axis, none empty
};

/// A cylinder about its centre.
SolidOfRevolution makeCylinder(const Vec3& centre, const Vec3& axis, double radius, double halfHeight);

/// A cone whose tip is `height` from the centre of its base, along the axis.
SolidOfRevolution makeCone(const Vec3& centreOfBase, const Vec3& axis, double radius, double height);

/// The convex hull of two spheres, neither inside the other (asserted); a capsule if the radii are equal.
SolidOfRevolution makeTaperedCapsule(const Vec3& centreA, double radiusA, const Vec3& centreB,
                                     double radiusB);

/// A sphere about the body's x axis.
SolidOfRevolution asSolidOfRevolution(const Sphere& sphere);

/// In closed form.
VolumeMoments volumeMoments(const SolidOfRevolution& solid);

/// m^2, flat ends included.
double surfaceArea(const SolidOfRevolution& solid);

}  // namespace bullet_buoyancy
