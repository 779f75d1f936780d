#pragma once

#include "bullet_buoyancy/motion/free_flight.h"
#include "bullet_buoyancy/motion/load.h"

namespace bullet_buoyancy {

/// Kinetic energy and the load's potential, J.
inline double totalEnergy(const Motion& motion, const Inertia& inertia, const Load& load) {
    return kineticEnergy(motion, inertia) + load.potential;
}

/// The part of the kinetic energy that loads along `up` cannot change, but for what the body's turning makes
/// of it, J.
double keptEnergy(const Motion& motion, const Inertia& inertia, const Vec3& up);

struct EnergyLimit {
    double available;  ///< J
    Vec3 up;           ///< see LoadField
    bool strict;       ///< take it from the spin about `up`, too
};

/// Takes from a motion what it has of energy beyond the limit, if that is more than rounding: by an impulse
/// along the load, and if that is not enough by slowing it along `up` and about the horizontal. Momentum that
/// the load cannot change, along the surface and about the vertical, is kept, unless the limit is strict: a
/// turn made in one large step may have raised the energy of the spin about the vertical. Where the pose
/// itself holds more than is available, what may be stopped is stopped.
void limitEnergy(Motion& motion, const Inertia& inertia, const Load& load, const EnergyLimit& limit);

}  // namespace bullet_buoyancy
