#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// A box that spins in free space: no gravity, no water.
struct TumbleDef {
    Vec3 halfExtents{0.05, 0.05, 1};  ///< m
    Vec3 spin{3, 0, 6};               ///< at the start, along the body's and the world's axes, rad/s
    double seconds = 10;
    Floater floater = Floater::library;  ///< `impulses`: the rotation is Bullet's own
    Stepping stepping;
};

/// Largest deviations from what is conserved, and from the reference (`rotateFreely`) at the same times.
/// Momentum is what the poses alone show: by the turn of a step at constant spin, in its middle. That differs
/// from the true one by the order of (spin dt)^2.
struct TumbleError {
    double energy;       ///< relative, as reported
    double momentum;     ///< of the length of L, relative
    double direction;    ///< of L, radians
    double orientation;  ///< angle to the reference's, radians
    bool finite;
};
TumbleError tumble(const TumbleDef& def);

}  // namespace bullet_buoyancy::scenes
