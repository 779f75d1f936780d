#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy::scenes {

/// The hull of Wigley (1934), parabolic in waterlines and sections, with walls above the design waterline
/// and a deck: half breadth B/2 (1 - (2 x / L)^2) (1 - (z / T)^2), z = 0 from there up.
///
/// Below the design waterline the volume is 4/9 L B T, its centre at z = -3/8 T, and the waterplane 2/3 L B.
struct WigleyDef {
    double length = 10;    ///< L, m
    double beam = 2.5;     ///< B, m
    double draft = 1;      ///< T, m
    double freeboard = 1;  ///< of the deck above the design waterline, m
    int stations = 40;     ///< panels along the length; even
    int waterlines = 12;   ///< panels from the keel to the design waterline
};

/// Closed; x from midships to the bow, y to port, z up from the design waterline.
TriangleMesh wigleyMesh(const WigleyDef& def = {});

}  // namespace bullet_buoyancy::scenes
