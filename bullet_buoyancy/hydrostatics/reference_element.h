#pragma once

#include <Eigen/Geometry>

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds a small piece of wet surface at one point to integrals by quadrature. `areaVector` points outward,
/// `up` is the vertical, both in the body's frame; depth and head in m, the same where pressure is
/// hydrostatic.
///
/// Volumes by the divergence theorem with fields that vanish at depth 0, whatever the surface's shape: water
/// is lifted straight up by the depth. The integral of the head up to the surface is taken for depth * head /
/// 2: exact where pressure is hydrostatic, else to first order in how the head departs from the depth.
inline void addElement(const Vec3& position, double depth, double head, const Vec3& areaVector,
                       const Vec3& up, WetIntegrals& sums) {
    const double areaUp = areaVector.dot(up);
    const Vec3 shadow = position + depth * up;
    sums.headNormal += head * areaVector;
    sums.headTorque += head * position.cross(areaVector);
    sums.volume -= depth * areaUp;
    sums.volumeMoment -= areaUp * depth * (position + depth / 2 * up);
    sums.headVolume -= depth * head / 2 * areaUp;
    sums.wettedArea += areaVector.norm();
    sums.waterplane.area -= areaUp;
    sums.waterplane.firstMoment -= areaUp * shadow;
    sums.waterplane.secondMoment -= areaUp * shadow * shadow.transpose();
}

}  // namespace bullet_buoyancy
