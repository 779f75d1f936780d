#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// A hull, 6 m by 2 m by 1 m and half as dense as water, whose centre of mass is raised above its middle.
struct CapsizeDef {
    double raised = 0.25;  ///< m
    double heel = 0.1;     ///< when let go, radians
    double seconds = 120;
    Floater floater = Floater::library;
    Stepping stepping;
};

struct CapsizeResult {
    double metacentricHeight;  ///< GM in closed form, m: above 0 it must come upright, below 0 it must not
    double mostHeel;           ///< at any time, 0 to pi
    double endHeel;            ///< 0 to pi
    bool finite;
};
CapsizeResult heelHull(const CapsizeDef& def);

}  // namespace bullet_buoyancy::scenes
