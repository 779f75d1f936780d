#pragma once

#include <vector>

#include "scenes/floating_log.h"
#include "scenes/known_answers.h"

namespace bullet_buoyancy::scenes {

struct CubeDef {
    double ratio = 0.5;            ///< density over the water's
    double size = 1;               ///< edge, m
    double dropHeight = 2;         ///< of the centre above the water, edges
    double linearDrag = 3;         ///< 1/s under water
    double angularDamping = 1.01;  ///< 1/s under water
    double seconds = 60;           ///< simulated
};

/// The cube at one moment of its fall.
struct CubeSample {
    double time;    ///< s
    double height;  ///< of the centre above the water, edges
    double tilt;    ///< of the axis nearest to the vertical, from the vertical
    double energy;  ///< kinetic, gravitational and the water's, J
};

struct CubeResult {
    std::vector<CubeSample> samples;  ///< one a step
    CubeOrientation reached;          ///< of the stable orientations, the nearest to where it came to rest
    double tiltDeviation;             ///< from it, radians; 0 where it is not known in closed form
    bool atRest;                      ///< false: it was not given the time to settle
    double submergedFraction;         ///< at rest: the ratio, by Archimedes
};

/// Drops a cube, turned out of all symmetry, from above the water, and lets it settle.
CubeResult dropCube(const CubeDef& def, const Stepping& stepping = {});

/// Mean period (s) of the heave of a flat slab (2 by 2 by 1 m) without drag, released `amplitude` (m) above
/// its draft, over at least 60 s, and its draft: the mean of its highest and lowest position (m).
struct HeaveResult {
    double period;
    double draft;
};
HeaveResult heaveSlab(double ratio, double amplitude, const Stepping& stepping = {});

}  // namespace bullet_buoyancy::scenes
