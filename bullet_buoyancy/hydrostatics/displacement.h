#pragma once

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// What a body displaces of water under a plane, in the body's frame about its origin.
struct Displacement {
    double volume = 0;                 ///< m^3
    Vec3 volumeMoment = Vec3::Zero();  ///< of the position over the volume, m^4
    double headVolume = 0;             ///< of the depth over the volume, m^4
    double error = 0;                  ///< upper bound of that of the volume, m^3

    Displacement& operator+=(const Displacement& other) {
        volume += other.volume;
        volumeMoment += other.volumeMoment;
        headVolume += other.headVolume;
        error += other.error;
        return *this;
    }
};

}  // namespace bullet_buoyancy
