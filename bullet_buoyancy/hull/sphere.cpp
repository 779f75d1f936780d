#include "bullet_buoyancy/hull/sphere.h"

#include <cmath>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

VolumeMoments volumeMoments(const Sphere& sphere) {
    const double volume = 4 * pi / 3 * std::pow(sphere.radius, 3);
    const double secondMoment = volume * sphere.radius * sphere.radius / 5;
    return moved({volume, Vec3::Zero(), secondMoment * Mat3::Identity()}, sphere.centre);
}

double surfaceArea(const Sphere& sphere) {
    return 4 * pi * sphere.radius * sphere.radius;
}

}  // namespace bullet_buoyancy
