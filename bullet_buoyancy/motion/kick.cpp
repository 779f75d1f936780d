#include "bullet_buoyancy/motion/kick.h"

namespace bullet_buoyancy {

namespace {

/// What the drag took: the work of the force less the kinetic energy gained.
double kickVelocity(const Kick& kick, Vec3& velocity, const Inertia& inertia, const Vec3& acceleration) {
    const Vec3 before = velocity, relative = velocity - kick.mediumVelocity;
    velocity = kick.mediumVelocity + kick.linear.advance(relative, acceleration, kick.extraForce);
    if (kick.linear.rate == 0 || kick.extraForce > 0) return 0;
    const Vec3 travel = kick.linear.travel(relative, acceleration) + kick.linear.dt * kick.mediumVelocity;
    return inertia.mass * (acceleration.dot(travel) - (velocity.squaredNorm() - before.squaredNorm()) / 2);
}

double kickRotation(const Kick& kick, Motion& motion, const Inertia& inertia, const Push& push) {
    const Vec3 momentum = motion.momentum, spin = motion.spin;
    motion.spin = kick.angular.advance(spin, push.angularAcceleration, kick.extraTorque);
    motion.momentum = inertia.turnsFreely ? kick.angular.advance(momentum, push.torque, kick.extraTorque)
                                          : inertia.momentum(motion.pose.orientation, motion.spin);
    if (kick.angular.rate == 0 || kick.extraTorque > 0) return 0;
    return push.torque.dot(kick.angular.travel(spin, push.angularAcceleration)) -
           (motion.momentum.dot(motion.spin) - momentum.dot(spin)) / 2;
}

}  // namespace

Dissipation Kick::apply(Motion& motion, const Inertia& inertia, const Push& push) const {
    const double byDrag = kickVelocity(*this, motion.velocity, inertia, push.acceleration);
    return {byDrag, kickRotation(*this, motion, inertia, push)};
}

}  // namespace bullet_buoyancy
