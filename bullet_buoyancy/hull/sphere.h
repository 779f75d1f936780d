#pragma once

#include "bullet_buoyancy/hull/volume_moments.h"

namespace bullet_buoyancy {

/// A ball.
struct Sphere {
    Vec3 centre = Vec3::Zero();  ///< in the body's frame, m
    double radius = 0;           ///< m
};

/// In closed form.
VolumeMoments volumeMoments(const Sphere& sphere);

/// m^2
double surfaceArea(const Sphere& sphere);

}  // namespace bullet_buoyancy
