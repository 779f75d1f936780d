#include "bullet_buoyancy/bullet/rigid_body_state.h"

namespace bullet_buoyancy {

namespace {

/// Bullet's only way to set them is to add to them what the body's factors leave.
void setForces(btRigidBody& body, const btVector3& force, const btVector3& torque) {
    const btVector3 linearFactor = body.getLinearFactor(), angularFactor = body.getAngularFactor();
    body.setLinearFactor({1, 1, 1});
    body.setAngularFactor(btVector3(1, 1, 1));
    body.clearForces();
    body.applyCentralForce(force);
    body.applyTorque(torque);
    body.setLinearFactor(linearFactor);
    body.setAngularFactor(angularFactor);
}

}  // namespace

RigidBodyState::RigidBodyState()
    : transform(btTransform::getIdentity()),
      interpolation(btTransform::getIdentity()),
      velocity(0, 0, 0),
      spin(0, 0, 0),
      interpolationVelocity(0, 0, 0),
      interpolationSpin(0, 0, 0),
      force(0, 0, 0),
      torque(0, 0, 0),
      gravity(0, 0, 0),
      linearDamping(0),
      angularDamping(0),
      deactivationTime(0),
      activation(ACTIVE_TAG),
      flags(0) {}

RigidBodyState::RigidBodyState(const btRigidBody& body)
    : transform(body.getWorldTransform()),
      interpolation(body.getInterpolationWorldTransform()),
      velocity(body.getLinearVelocity()),
      spin(body.getAngularVelocity()),
      interpolationVelocity(body.getInterpolationLinearVelocity()),
      interpolationSpin(body.getInterpolationAngularVelocity()),
      force(body.getTotalForce()),
      torque(body.getTotalTorque()),
      gravity(body.getGravity()),
      linearDamping(body.getLinearDamping()),
      angularDamping(body.getAngularDamping()),
      deactivationTime(body.getDeactivationTime()),
      activation(body.getActivationState()),
      flags(body.getFlags()) {}

void RigidBodyState::putInto(btRigidBody& body) const {
    body.setWorldTransform(transform);
    body.setInterpolationWorldTransform(interpolation);
    body.updateInertiaTensor();
    body.setLinearVelocity(velocity);
    body.setAngularVelocity(spin);
    body.setInterpolationLinearVelocity(interpolationVelocity);
    body.setInterpolationAngularVelocity(interpolationSpin);
    setForces(body, force, torque);
    if (body.getGravity() != gravity) body.setGravity(gravity);  // its weight may be rounded otherwise
    body.setDamping(linearDamping, angularDamping);
    body.setFlags(flags);
    body.forceActivationState(activation);
    body.setDeactivationTime(deactivationTime);
}

}  // namespace bullet_buoyancy
