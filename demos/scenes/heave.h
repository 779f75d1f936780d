#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// A slab, 2 by 2 by 1 m and half as dense as water, let go 0.1 m above its draft without friction for 60 s.
struct HeaveDef {
    Floater floater = Floater::library;
    Stepping stepping;
};

/// Relative errors of the last full periods; extremes are taken from the parabola through the three samples
/// around them.
struct HeaveError {
    double amplitudeLost;  ///< share of the 0.1 m; below 0: gained
    double period;         ///< |mean of all periods / analytic - 1|
    bool finite;
};
HeaveError heaveFreely(const HeaveDef& def);

}  // namespace bullet_buoyancy::scenes
