#include "bullet_buoyancy/motion/kick.h"

namespace bullet_buoyancy {

namespace {

/// What the drag took: the work of the force less the kinetic energy gained.
double kickVelocity(const Kick& kick, Vec3& velocity, const Inertia& inertia, const Vec3& force) {
    const Vec3 acceleration = inertia.velocityChange(force);
    const Vec3 before = velocity, relative = velocity - kick.mediumVelocity;
    velocity = kick.mediumVelocity + kick.linear.advance(relative, acceleration, kick.extraForce);
    if (kick.linear.rate == 0 || kick.extraForce > 0) return 0;
    const Vec3 travel = kick.linear.travel(relative, acceleration) + kick.linear.dt * kick.mediumVelocity;
    return inertia.mass * (acceleration.dot(travel) - (velocity.squaredNorm() - before.squaredNorm()) / 2);
}

double kickMomentum(const Kick& kick, Motion& motion, const Inertia& inertia, const Vec3& torque) {
    const Vec3 momentum = motion.momentum, spin = motion.spin;
    motion.setMomentum(inertia, kick.angular.advance(momentum, torque, kick.extraTorque));
    if (kick.angular.rate == 0 || kick.extraTorque > 0) return 0;
    const Vec3 turn = inertia.spin(motion.pose.orientation, kick.angular.travel(momentum, torque));
    return torque.dot(turn) - (motion.momentum.dot(motion.spin) - momentum.dot(spin)) / 2;
}

double kickSpin(const Kick& kick, Motion& motion, const Inertia& inertia, const Vec3& torque) {
    const Vec3 momentum = motion.momentum, spin = motion.spin;
    const Vec3 acceleration = inertia.spinChange(motion.pose.orientation, torque);
    motion.setSpin(inertia, kick.angular.advance(spin, acceleration, kick.extraTorque));
    if (kick.angular.rate == 0 || kick.extraTorque > 0) return 0;
    return torque.dot(kick.angular.travel(spin, acceleration)) -
           (motion.momentum.dot(motion.spin) - momentum.dot(spin)) / 2;
}

}  // namespace

Dissipation Kick::apply(Motion& motion, const Inertia& inertia, const Vec3& force, const Vec3& torque) const {
    const double byDrag = kickVelocity(*this, motion.velocity, inertia, force);
    const double byDamping = inertia.turnsFreely ? kickMomentum(*this, motion, inertia, torque)
                                                 : kickSpin(*this, motion, inertia, torque);
    return {byDrag, byDamping};
}

}  // namespace bullet_buoyancy
