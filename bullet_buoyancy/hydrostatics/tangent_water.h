#pragma once

#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Water whose head is linear, with the slope and head that a patch has at a point: as flat water, but with
/// its surface tilted and its pressure growing by `steepness` a metre of distance from it.
struct TangentWater {
    WaterPlane plane;
    double steepness;
    double steepnessUpright;  ///< growth of the head a metre straight down

    /// With that head and gradient of it at a point.
    TangentWater(double headThere, const Vec3& gradient, const Vec3& up, const Vec3& pointInBody)
        : steepness(gradient.norm()), steepnessUpright(-gradient.dot(up)) {
        plane = {-gradient / steepness, (headThere - gradient.dot(pointInBody)) / steepness};
    }

    /// Where the point is less than `reach` (m) from the surface the one at the surface above or below it.
    TangentWater(const WaterExpansion& water, const Vec3& up, const Vec3& pointInBody, double reach) {
        const double depth = water.depthAt(pointInBody);
        const Vec3 at = std::abs(depth) < reach ? Vec3(pointInBody + depth * up) : pointInBody;
        const Vec3 gradient = water.head.gradient + water.head.bend * (at - water.centre);
        steepness = gradient.norm();
        steepnessUpright = -gradient.dot(up);
        plane = {-gradient / steepness, (water.headAt(at) - gradient.dot(at)) / steepness};
    }

    double head(const Vec3& pointInBody) const { return steepness * plane.depth(pointInBody); }

    /// Straight up to the surface, m.
    double depth(const Vec3& pointInBody) const { return head(pointInBody) / steepnessUpright; }

    /// What `of` collected in terms of distance from the plane, and across it, in terms of head and of what
    /// is straight below.
    void add(const WetIntegrals& of, WetIntegrals& integrals) const {
        const double shadow = steepnessUpright / steepness;
        integrals.headNormal += steepness * of.headNormal;
        integrals.headTorque += steepness * of.headTorque;
        integrals.volume += of.volume;
        integrals.volumeMoment += of.volumeMoment;
        integrals.headVolume += steepness * of.headVolume;
        integrals.wettedArea += of.wettedArea;
        integrals.waterplane.area += shadow * of.waterplane.area;
        integrals.waterplane.firstMoment += shadow * of.waterplane.firstMoment;
        integrals.waterplane.secondMoment += shadow * of.waterplane.secondMoment;
    }
};

}  // namespace bullet_buoyancy
