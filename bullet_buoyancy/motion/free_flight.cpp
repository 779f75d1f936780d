#include "bullet_buoyancy/motion/free_flight.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/motion/calm_limits.h"
#include "bullet_buoyancy/motion/free_rotation.h"

namespace bullet_buoyancy {

namespace {

/// The product of two unit quaternions is one but for rounding: a step of Newton's makes it so.
Eigen::Quaterniond product(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    Eigen::Quaterniond q = a * b;
    q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
    return q;
}

Eigen::Quaterniond turnedAtSpin(const Eigen::Quaterniond& orientation, const Vec3& spin, double dt,
                                double limit) {
    const double rate = spin.norm();
    if (rate == 0) return orientation;
    const double angle = std::clamp(rate * dt, -limit, limit);
    return product(Eigen::Quaterniond(Eigen::AngleAxisd(angle, spin / rate)), orientation);
}

/// Cut short in time where the turn would be too large, so that no energy is made of it.
Eigen::Quaterniond turnedByMomentum(const Motion& motion, const Inertia& inertia, double dt, double limit) {
    const Eigen::Quaterniond& orientation = motion.pose.orientation;
    const Vec3 momentumInBody = orientation.conjugate() * motion.momentum;
    constexpr double margin = 1 - 1e-9;
    const double expectedSquare = motion.spin.squaredNorm() * dt * dt;
    if (const double small = std::min(gentleTurn, limit); expectedSquare < small * small)
        return product(orientation, turnGently(inertia.principal, momentumInBody, dt));
    const double expected = std::sqrt(expectedSquare);
    double time = expected > margin * limit ? dt * margin * limit / expected : dt;
    for (int attempt = 0;; ++attempt) {
        const Eigen::Quaterniond turn = turnFreely(inertia.principal, momentumInBody, time);
        const double halfAngle = std::atan2(turn.vec().norm(), std::abs(turn.w()));
        if (2 * halfAngle <= limit || attempt == 8) return product(orientation, turn);
        time *= margin * limit / (2 * halfAngle);
    }
}

}  // namespace

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
