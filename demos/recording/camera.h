#pragma once

#include <vector>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy::recording {

/// A camera, y up.
struct Camera {
    Vec3 position;   ///< m
    Vec3 target;     ///< in the middle of the picture
    double tangent;  ///< of half the angle that it sees from left to right
};

/// One that looks down by `elevation` (rad) from the side `azimuth` (rad, from z towards x), from as near as
/// all `points` (at least one) are seen in a picture `aspect` times as wide as high.
Camera aimCamera(const std::vector<Vec3>& points, double azimuth, double elevation, double aspect);

}  // namespace bullet_buoyancy::recording
