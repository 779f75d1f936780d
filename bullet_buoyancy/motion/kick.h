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

/// A constant force and torque on a body, by how it answers at its orientation.
struct Push {
    Vec3 torque;               ///< N m
    Vec3 acceleration;         ///< m/s^2
    Vec3 angularAcceleration;  ///< rad/s^2

    Push() : Push(Inertia(), Eigen::Quaterniond::Identity(), Vec3::Zero(), Vec3::Zero()) {}
    /// `force` in N.
    Push(const Inertia& inertia, const Eigen::Quaterniond& orientation, const Vec3& force,
         const Vec3& itsTorque)
        : torque(itsTorque),
          acceleration(inertia.velocityChange(force)),
          angularAcceleration(inertia.spinChange(orientation, itsTorque)) {}

    friend Push operator*(double share, Push push) {
        for (Vec3* part : {&push.torque, &push.acceleration, &push.angularAcceleration})
            *part *= share;
        return push;
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

    /// `push`: over the half step, at the motion's orientation.
    Dissipation apply(Motion& motion, const Inertia& inertia, const Push& push) const;
    /// `force` in N and `torque` in N m, likewise.
    Dissipation apply(Motion& motion, const Inertia& inertia, const Vec3& force, const Vec3& torque) const {
        return apply(motion, inertia, Push(inertia, motion.pose.orientation, force, torque));
    }
};

}  // namespace bullet_buoyancy
