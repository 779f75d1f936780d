#pragma once

#include <array>

#include "bullet_buoyancy/hull/solid_of_revolution.h"
#include "bullet_buoyancy/water/water_plane.h"

namespace bullet_buoyancy {

/// A solid's axis seen from the water. Axial coordinates x count from `origin`; within a section, s runs
/// along `rising`, the direction in the section in which depth falls fastest: depth(x, s) = depthAtOrigin -
/// upAlong x - upAcross s.
struct AxisInWater {
    Vec3 origin, axis, rising;
    double upAlong;
    double upAcross;  // >= 0
    double depthAtOrigin;

    double depth(double x) const { return depthAtOrigin - upAlong * x; }
};

AxisInWater axisInWater(const SolidOfRevolution& solid, const WaterPlane& plane);

/// Ends of the stretches of a piece in which sections are wholly dry, wholly wet or cut: its own ends and,
/// between them, the roots of upAcross^2 radius^2 - depth^2.
std::array<double, 4> stretchEnds(const ProfilePiece& piece, const AxisInWater& view);

}  // namespace bullet_buoyancy
