#pragma once

namespace bullet_buoyancy {

/// Where a body's energy came from and went to since the action first stepped it, J.
struct EnergyLedger {
    double start = 0;     ///< kinetic and potential energy when it was first stepped
    double byOthers = 0;  ///< done on it by contacts, joints, the user, moving it by hand

    /// Done on it by the pressure of water that moves: what drag, damping and others leave of the change.
    /// What is lost to the steps there is in it, and where others move the body by hand the change in
    /// potential.
    double byWater = 0;

    double toDrag = 0;     ///< taken by the drag
    double toDamping = 0;  ///< taken by the angular damping

    /// What the body ought to have now. What it has less is lost to the steps.
    double expected() const { return start + byOthers + byWater - toDrag - toDamping; }
};

}  // namespace bullet_buoyancy
