#include "bullet_buoyancy/motion/energy_guard.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/motion/energy.h"

namespace bullet_buoyancy {

namespace {

/// An impulse x times the load changes the kinetic energy by x power + x^2 / 2 admittance: the smallest that
/// takes `surplus`, or else as much as one can.
void brakeAlongLoad(Motion& motion, const Inertia& inertia, const Load& load, double surplus) {
    const double power = load.force.dot(motion.velocity) + load.torque.dot(motion.spin);
    const double admittance = load.force.dot(inertia.velocityChange(load.force)) +
                              load.torque.dot(inertia.spinChange(motion.pose.orientation, load.torque));
    if (!(admittance > 0)) return;
    const double discriminant = power * power - 2 * admittance * surplus;
    const double impulse = discriminant > 0
                               ? -2 * surplus / (power + std::copysign(std::sqrt(discriminant), power))
                               : -power / admittance;
    motion.push(inertia, impulse * load.force, impulse * load.torque);
}

/// With `share` of the motion that loads along `up` can change.
Motion slowed(const Motion& motion, const Inertia& inertia, const Vec3& up, double share) {
    const auto slowedPart = [&](const Vec3& changeable) { return Vec3((share - 1) * changeable); };
    const auto along = [&](const Vec3& v) { return Vec3(up.dot(v) * up); };
    Motion slower = motion;
    slower.velocity += slowedPart(along(motion.velocity));
    if (inertia.turnsFreely)
        slower.setMomentum(inertia, motion.momentum + slowedPart(motion.momentum - along(motion.momentum)));
    else
        slower.setSpin(inertia, motion.spin + slowedPart(motion.spin - along(motion.spin)));
    return slower;
}

/// To the largest share whose kinetic energy is allowed, or else to that of the least energy. It is a
/// parabola of the share, here through three of its points; what turns about the vertical may keep it from 0.
void slow(Motion& motion, const Inertia& inertia, const Vec3& up, double allowed) {
    const double at0 = kineticEnergy(slowed(motion, inertia, up, 0), inertia),
                 atHalf = kineticEnergy(slowed(motion, inertia, up, 0.5), inertia),
                 at1 = kineticEnergy(motion, inertia);
    const double a = 2 * (at0 + at1 - 2 * atHalf), b = at1 - at0 - a;
    if (!(a > 0)) return;
    const double discriminant = std::max(0.0, b * b - 4 * a * (at0 - allowed));
    const double share = std::clamp((std::sqrt(discriminant) - b) / (2 * a), 0.0, 1.0);
    motion = slowed(motion, inertia, up, share);
}

/// What turning about the horizontal drives of the motion along `up` is not slowed with it.
void slowAlong(Motion& motion, const Inertia& inertia, const Vec3& up, double surplus) {
    const double speed = up.dot(motion.velocity), energy = inertia.mass * speed * speed / 2;
    if (!(energy > 0)) return;
    motion.velocity += (std::sqrt(std::max(0.0, 1 - surplus / energy)) - 1) * speed * up;
}

void slowTurning(Motion& motion, const Inertia& inertia, double allowed) {
    const double ofTranslation = translationalEnergy(inertia.mass, motion.velocity);
    const double ofRotation = kineticEnergy(motion, inertia) - ofTranslation;
    const double left = ofRotation > 0 ? std::clamp((allowed - ofTranslation) / ofRotation, 0.0, 1.0) : 1;
    motion.setSpin(inertia, std::sqrt(left) * motion.spin);
}

}  // namespace

double keptEnergy(const Motion& motion, const Inertia& inertia, const Vec3& up) {
    return std::min(kineticEnergy(motion, inertia), kineticEnergy(slowed(motion, inertia, up, 0), inertia));
}

void limitEnergy(Motion& motion, const Inertia& inertia, const Load& load, const EnergyLimit& limit) {
    const auto surplus = [&] { return totalEnergy(motion, inertia, load) - limit.available; };
    const double before = surplus();
    if (!(before > load.potentialRounding)) return;
    const double negligible = 1e-9 * before + 1e-12 * std::abs(load.potential);  // rounding
    brakeAlongLoad(motion, inertia, load, before);
    if (surplus() <= negligible) return;
    slow(motion, inertia, limit.up, limit.available - load.potential);
    if (surplus() > negligible) slowAlong(motion, inertia, limit.up, surplus());
    constexpr double strayed = 1e-4;  // of what is in motion: no sign of a turn too large
    if (limit.strict && surplus() > strayed * kineticEnergy(motion, inertia))
        slowTurning(motion, inertia, limit.available - load.potential);
}

}  // namespace bullet_buoyancy
