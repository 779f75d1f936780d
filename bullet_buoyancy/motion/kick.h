#pragma once

#include "bullet_buoyancy/motion/damping.h"
#include "bullet_buoyancy/motion/free_flight.h"
#include "bullet_buoyancy/motion/load.h"

namespace bullet_buoyancy {

/// Energy that a medium has taken, J; below zero where it drags a body along.
struct Dissipation {
    double byDrag = 0, byDamping = 0;

    double sum() const { return byDrag + byDamping; }
    Dissipation& operator+=(const Dissipation& other) {
        byDrag += other.byDrag;
        byDamping += other.byDamping;
        return *this;
    }
};

/// What changes a body's velocity and momentum at one pose: half a step before it, and half a step after it,
/// with the body flying free from pose to pose (Stormer and Verlet; Hairer, Lubich and Wanner, Geometric
/// Numerical Integration, I.1.4). Two kicks with the same load make a DampedStep over the whole step.
struct Kick {
    DampedStep linear, angular;
    Vec3 mediumVelocity;
    double extraForce = 0, extraTorque = 0;  ///< times for which these act without drag, s

    Kick() : Kick(Load(), 1) {}

    /// Half of a step of `dt` (s) in the medium that `load` tells of.
    Kick(const Load& load, double dt)
        : linear(load.dragRate, dt / 2),
          angular(load.dampingRate, dt / 2),
          mediumVelocity(load.mediumVelocity) {}

    /// `force` in N and `torque` in N m, constant over the half step.
    Dissipation apply(Motion& motion, const Inertia& inertia, const Vec3& force, const Vec3& torque) const;
};

}  // namespace bullet_buoyancy
