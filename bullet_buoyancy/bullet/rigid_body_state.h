#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet_buoyancy/bullet/precision.h"

namespace bullet_buoyancy {

/// What a step of Bullet changes of a rigid body, and what the next step depends on. The action saves it of
/// the bodies that it floats; use it for those that it does not.
///
/// Not here, since Bullet keeps it elsewhere or it is the user's: contacts, joints, the motion state; mass,
/// inertia, factors, shape, collision flags, and whether the body is in a world.
struct RigidBodyState {
    btTransform transform, interpolation;
    btVector3 velocity, spin;                            ///< m/s, rad/s
    btVector3 interpolationVelocity, interpolationSpin;  ///< m/s, rad/s
    btVector3 force, torque;                             ///< applied since they were last cleared, N, N m
    btVector3 gravity;                                   ///< m/s^2
    btScalar linearDamping, angularDamping;
    btScalar deactivationTime;  ///< s
    int activation;
    int flags;

    /// With transforms of identity and zeros.
    RigidBodyState();
    explicit RigidBodyState(const btRigidBody& body);

    /// The body's inertia in the world is made anew from its transform. One in a world without contacts goes
    /// on to the last bit as the saved one did.
    void putInto(btRigidBody& body) const;
};

}  // namespace bullet_buoyancy
