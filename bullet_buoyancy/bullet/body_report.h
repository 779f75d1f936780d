#pragma once

#include <LinearMath/btVector3.h>

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/motion/energy_ledger.h"

namespace bullet_buoyancy {

/// What the action did with a body in the last substep.
enum class BodyState {
    notAdded,    ///< the action does not know the body
    notStepped,  ///< added, but no substep has been taken since
    dry,         ///< above the water
    floating,    ///< partly under water
    submerged,   ///< wholly under water
    asleep,      ///< left asleep; without kinetic energy; the other fields are those of its last step
    notInWorld,  ///< not touched: removed from the world
    notDynamic,  ///< not touched: made static or kinematic
    notFinite,  ///< not touched: pose, velocity, mass or inertia is NaN or infinite, or would be after a step
    badStep,    ///< not touched: the step was zero, negative or not finite
};

/// Which effects acted in the last substep.
struct Modelled {
    bool hydrostatics = false;     ///< pressure of the water
    bool linearDrag = false;       ///< of the water, or Bullet's own linear damping
    bool angularDamping = false;   ///< of the water
    bool angularMomentum = false;  ///< the spin follows from it; false: the body cannot turn freely
};

/// What the water does to a body, at the pose at the end of the last substep that it took part in; zeros
/// before the first, and where a step was not finite.
struct BodyReport {
    BodyState state = BodyState::notAdded;  ///< look here first: it says whether the rest is of this step
    Modelled modelled;                      ///< what acted
    btVector3 forceWorld{0, 0, 0};          ///< of the water's pressure, N
    double forceErrorBound = 0;             ///< it is no farther than this from that of the true surface, N
    btVector3 torqueAboutCom{0, 0, 0};      ///< of the water's pressure, world axes, N m
    double submergedVolume = 0;             ///< m^3
    double wetFraction =
        0;  ///< submerged volume over the hull's, 0 to 1; a rough figure where the hull is open
    btVector3 centreOfBuoyancyWorld{0, 0, 0};  ///< m; the centre of mass where nothing is displaced
    btVector3 velocity{0, 0, 0};               ///< of the centre of mass at the pose, m/s
    btVector3 spin{0, 0, 0};                   ///< at the pose, world axes, rad/s
    btVector3 angularMomentum{0, 0, 0};        ///< about the centre of mass, world axes, kg m^2/s
    double kineticEnergy = 0;                  ///< translation and rotation, at the time of the pose, J
    double gravitationalEnergy = 0;            ///< zero at the water frame's origin, J
    double waterPotentialEnergy = 0;           ///< integral of the pressure over the displacement, J

    EnergyLedger energy;  ///< since it was first stepped, or last woken

    int evaluations = 0;         ///< of the water's pressure in the last substep; a body at ease needs one
    int waterSamples = 0;        ///< points at which they asked the water for its surface or head, in all
    bool spinIsLimited = false;  ///< it spins past pi/4 a substep: Bullet cannot follow, and it turns less
    bool shapeHasChanged =
        false;  ///< swapped or scaled since its hull was read: see `BuoyancyAction::updateHull`

    /// Compare with `energy.expected()`, J.
    double totalEnergy() const { return kineticEnergy + gravitationalEnergy + waterPotentialEnergy; }
};

}  // namespace bullet_buoyancy
