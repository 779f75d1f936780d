#pragma once

#include "bullet_buoyancy/motion/free_flight.h"
#include "bullet_buoyancy/motion/load.h"

namespace bullet_buoyancy {

/// Kinetic energy and the load's potential, J.
inline double totalEnergy(const Motion& motion, const Inertia& inertia, const Load& load) {
    return kineticEnergy(motion, inertia) + load.potential;
}

/// Takes from a motion what it has of energy beyond `available` (J), by an impulse along the load: momentum
/// that the load cannot change (along the water's surface, about the vertical) is kept. Where the pose itself
/// holds more than is available, what is left of the motion along the load is stopped. Returns what was
/// taken, J, at least 0.
double limitEnergy(Motion& motion, const Inertia& inertia, const Load& load, double available);

}  // namespace bullet_buoyancy
