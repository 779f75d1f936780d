#pragma once

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// The water near a body as a plane in the body's own frame: small numbers, however far the body is from the
/// world's origin.
struct WaterPlane {
    Vec3 upInBody = Vec3::UnitZ();  ///< the direction in which pressure falls, unit length
    double heightOfWater = 0;       ///< depth of the body's centre of mass: above zero under water, m

    /// Depth of a point of the body: above zero under water, m.
    double depth(const Vec3& pointInBody) const { return heightOfWater - upInBody.dot(pointInBody); }
};

/// The plane of water whose surface does not slope or bend (`bounds().isFlat()`:
/// asserted), seen from a body. One sample, at the centre of mass; none of a surface that `isLevel()`.
WaterPlane waterPlaneInBody(const WaterField& water, const Pose& pose, double time);

}  // namespace bullet_buoyancy
