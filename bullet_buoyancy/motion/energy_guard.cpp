#include "bullet_buoyancy/motion/energy_guard.h"

#include <cmath>

namespace bullet_buoyancy {

double limitEnergy(Motion& motion, const Inertia& inertia, const Load& load, double available) {
    const double before = kineticEnergy(motion, inertia);
    const double surplus = before + load.potential - available;
    if (!(surplus > 0)) return 0;
    // An impulse x times the load changes the kinetic energy by x power + x^2 / 2 admittance.
    const double power = load.force.dot(motion.velocity) + load.torque.dot(motion.spin);
    const double admittance = load.force.dot(inertia.velocityChange(load.force)) +
                              load.torque.dot(inertia.spinChange(motion.pose.orientation, load.torque));
    if (!(admittance > 0)) return 0;
    const double discriminant = power * power - 2 * admittance * surplus;
    const double impulse = discriminant > 0
                               ? -2 * surplus / (power + std::copysign(std::sqrt(discriminant), power))
                               : -power / admittance;
    motion.push(inertia, impulse * load.force, impulse * load.torque);
    return before - kineticEnergy(motion, inertia);
}

}  // namespace bullet_buoyancy
