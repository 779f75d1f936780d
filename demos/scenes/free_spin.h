#pragma once

#include <vector>

#include "bullet_buoyancy/core/math_types.h"
#include "scenes/floating_log.h"

namespace bullet_buoyancy::scenes {

/// Who steps the rotation of a body on which no torque acts.
enum class SpinOwner {
    bullet,   ///< Bullet's damping of the angular velocity, and its own gyroscopic term
    library,  ///< the library's damping of the angular momentum
};

struct SpinSample {
    double time;           ///< s
    Vec3 angularMomentum;  ///< world axes, kg m^2/s
};

struct SpinDef {
    Vec3 size{1.0, 0.6, 0.2};  ///< of a neutrally buoyant box, m: three different moments of inertia
    Vec3 spin{1.0, 6.0, 0.4};  ///< at the start, rad/s
    double dampingRate = 0.1;  ///< 1/s
    double seconds = 20;
};

/// The box spins, wholly under water, damped at the same rate by either owner.
std::vector<SpinSample> spinFreely(const SpinDef& def, SpinOwner owner, const Stepping& stepping = {});

/// How far the momenta stray from L(0) exp(-rate t): largest relative error of length, and angle of direction
/// (radians).
struct SpinError {
    double length, angle;
};
SpinError spinError(const std::vector<SpinSample>& samples, double dampingRate);

}  // namespace bullet_buoyancy::scenes
