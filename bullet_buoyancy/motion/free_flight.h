#pragma once

#include "bullet_buoyancy/motion/energy.h"
#include "bullet_buoyancy/motion/inertia.h"

namespace bullet_buoyancy {

/// Where a body is and how it moves, in world axes, in double precision.
struct Motion {
    Pose pose;
    Vec3 velocity = Vec3::Zero();  ///< m/s
    Vec3 momentum = Vec3::Zero();  ///< angular, about the centre of mass, kg m^2/s
    Vec3 spin = Vec3::Zero();      ///< rad/s; of a body that turns freely, what follows from the momentum

    void setMomentum(const Inertia& inertia, const Vec3& value) {  ///< and the spin that follows
        momentum = value;
        spin = inertia.spin(pose.orientation, value);
    }
    void setSpin(const Inertia& inertia, const Vec3& value) {  ///< and the momentum that follows
        spin = value;
        momentum = inertia.momentum(pose.orientation, value);
    }

    /// By an impulse (N s) and one of torque (N m s).
    void push(const Inertia& inertia, const Vec3& impulse, const Vec3& angularImpulse) {
        velocity += inertia.velocityChange(impulse);
        if (inertia.turnsFreely)
            setMomentum(inertia, momentum + angularImpulse);
        else
            setSpin(inertia, spin + inertia.spinChange(pose.orientation, angularImpulse));
    }

    /// To another pose, with the velocity, and the momentum of a body that turns freely or else the spin.
    void moveTo(const Inertia& inertia, const Pose& where) {
        pose = where;
        if (inertia.turnsFreely)
            setMomentum(inertia, momentum);
        else
            setSpin(inertia, spin);
    }
};

/// Translation and rotation, J.
inline double kineticEnergy(const Motion& motion, const Inertia& inertia) {
    return translationalEnergy(inertia.mass, motion.velocity) +
           rotationalEnergy(motion.momentum, motion.spin);
}

/// How a body turns between two poses.
enum class Turning {
    byMomentum,  ///< as its angular momentum says, spinning unsteadily
    atSpin,      ///< at the spin of the start. Of a body that turns freely: first order, and its energy grows
                 ///< without bound
};

/// After `dt` (s) in which nothing acts on the body. It turns along its true path, but not farther than
/// `turnLimit` (rad).
Motion fly(const Motion& motion, const Inertia& inertia, double dt, Turning turning,
           double turnLimit = largestTurn);

}  // namespace bullet_buoyancy
