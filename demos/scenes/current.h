#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// A crate in a current, with drag far too strong for explicit steps.
struct DriftDef {
    double ratio = 1;         ///< density over the water's; 1: wholly under water
    double linearDrag = 1e4;  ///< 1/s
    double current = 1;       ///< along x, m/s
    double startSpeed = -5;   ///< along x, m/s
    double seconds = 5;
    Floater floater = Floater::library;
    Stepping stepping;
};

/// In units of the speed relative to the water at the start.
struct CurrentResult {
    double overshoot;  ///< largest speed past the current's
    double remaining;  ///< |speed relative to the water| in the end
    bool finite;
};
CurrentResult driftInCurrent(const DriftDef& def);

}  // namespace bullet_buoyancy::scenes
