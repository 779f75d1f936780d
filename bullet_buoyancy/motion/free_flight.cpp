#include "bullet_buoyancy/motion/free_flight.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/motion/energy.h"
#include "bullet_buoyancy/motion/free_rotation.h"

namespace bullet_buoyancy {

namespace {

Eigen::Quaterniond turnedAtSpin(const Eigen::Quaterniond& orientation, const Vec3& spin, double dt,
                                double limit) {
    const double rate = spin.norm();
    if (rate == 0) return orientation;
    const double angle = std::clamp(rate * dt, -limit, limit);
    return (Eigen::Quaterniond(Eigen::AngleAxisd(angle, spin / rate)) * orientation).normalized();
}

/// Cut short in time where the turn would be too large, so that no energy is made of it.
Eigen::Quaterniond turnedByMomentum(const Motion& motion, const Inertia& inertia, double dt, double limit) {
    const Eigen::Quaterniond& orientation = motion.pose.orientation;
    const Vec3 momentumInBody = orientation.conjugate() * motion.momentum;
    constexpr double margin = 1 - 1e-9;
    const double expected = motion.spin.norm() * std::abs(dt);
    constexpr double gentle = 0.02;  // rad: 1.2 rad/s at 60 Hz
    if (expected < std::min(gentle, limit))
        return (orientation * turnGently(inertia.principal, momentumInBody, dt)).normalized();
    double time = expected > margin * limit ? dt * margin * limit / expected : dt;
    for (int attempt = 0;; ++attempt) {
        const Eigen::Quaterniond turn = turnFreely(inertia.principal, momentumInBody, time);
        const double halfAngle = std::atan2(turn.vec().norm(), std::abs(turn.w()));
        if (2 * halfAngle <= limit || attempt == 8) return (orientation * turn).normalized();
        time *= margin * limit / (2 * halfAngle);
    }
}

}  // namespace

void Motion::setMomentum(const Inertia& inertia, const Vec3& value) {
    momentum = value;
    spin = inertia.spin(pose.orientation, value);
}

void Motion::setSpin(const Inertia& inertia, const Vec3& value) {
    spin = value;
    momentum = inertia.momentum(pose.orientation, value);
}

void Motion::push(const Inertia& inertia, const Vec3& impulse, const Vec3& angularImpulse) {
    velocity += inertia.velocityChange(impulse);
    if (inertia.turnsFreely)
        setMomentum(inertia, momentum + angularImpulse);
    else
        setSpin(inertia, spin + inertia.spinChange(pose.orientation, angularImpulse));
}

void Motion::moveTo(const Inertia& inertia, const Pose& where) {
    pose = where;
    if (inertia.turnsFreely)
        setMomentum(inertia, momentum);
    else
        setSpin(inertia, spin);
}

double kineticEnergy(const Motion& motion, const Inertia& inertia) {
    return translationalEnergy(inertia.mass, motion.velocity) +
           rotationalEnergy(motion.momentum, motion.spin);
}

Motion fly(const Motion& motion, const Inertia& inertia, double dt, Turning turning, double turnLimit) {
    Pose end;
    end.position = motion.pose.position + dt * motion.velocity;
    end.orientation = turning == Turning::byMomentum
                          ? turnedByMomentum(motion, inertia, dt, turnLimit)
                          : turnedAtSpin(motion.pose.orientation, motion.spin, dt, turnLimit);
    Motion arrival = motion;
    arrival.moveTo(inertia, end);
    return arrival;
}

}  // namespace bullet_buoyancy
