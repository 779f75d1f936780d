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
    btTransform transform;            ///< body to world, m
    btTransform interpolation;        ///< of the last substep, from which Bullet interpolates
    btVector3 velocity;               ///< m/s
    btVector3 spin;                   ///< rad/s
    btVector3 interpolationVelocity;  ///< m/s
    btVector3 interpolationSpin;      ///< rad/s
    btVector3 force;                  ///< applied since it was last cleared, N
    btVector3 torque;                 ///< likewise, N m
    btVector3 gravity;                ///< m/s^2
    btScalar linearDamping;           ///< Bullet's: share lost in a second
    btScalar angularDamping;          ///< likewise
    btScalar deactivationTime;        ///< s
    int activation;                   ///< Bullet's activation state
    int flags;                        ///< Bullet's rigid body flags

    /// With transforms of identity and zeros.
    RigidBodyState();
    /// Of a body as it is now.
    explicit RigidBodyState(const btRigidBody& body);

    /// The body's inertia in the world is made anew from its transform. One in a world without contacts goes
    /// on to the last bit as the saved one did.
    void putInto(btRigidBody& body) const;
};

}  // namespace bullet_buoyancy
