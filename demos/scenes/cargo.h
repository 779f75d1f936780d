#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// How cargo rides on a raft that floats freely.
struct CargoResult {
    double displacementError;  ///< of the raft, over what the masses together displace
    double worstShift;         ///< of a piece along the raft's deck, over its size
    double worstHeightError;   ///< of a piece above the raft, over its size
    double tilt;               ///< of the raft, radians
    bool finite;
};

/// Ten crates of 0.8 m in one stack amidships on a raft of 8 by 8 by 1 m, for 20 s: the stack creeps, as it
/// does on the ground.
CargoResult stackCratesOnRaft(Floater floater, const Stepping& stepping = {});

/// A crate of 300 kg on an inflatable raft of 30 kg, 3 by 1.5 by 0.4 m, for a minute: it is damped by its
/// own small mass only.
CargoResult loadInflatableRaft(Floater floater, const Stepping& stepping = {});

}  // namespace bullet_buoyancy::scenes
