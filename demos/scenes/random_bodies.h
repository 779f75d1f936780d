#pragma once

#include <cstdint>

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

struct RandomBodiesDef {
    int bodies = 1000;
    int stepsEach = 100;
    std::uint64_t seed = 1;
    Floater floater = Floater::library;
};

/// Boxes, balls, capsules and cylinders of 0.02 to 10 m and 1e-4 to 2 times the water's density, each alone,
/// let go anywhere near the water at any turn, speed and spin, at steps of 1/240 to 1/10 s, without friction.
///
/// A body's energy is compared in units of all that there is at its release, each part of it counted from
/// where it can be no less: kinetic energy, that of the water (both never below 0), and weight times distance
/// from the surface and size of the body, by which it is to move.
struct RandomBodiesResult {
    double worstGain;         ///< largest (energy - energy at release) / scale of any body at any step
    std::uint64_t worstBody;  ///< its number
    int gainers;              ///< bodies that gain more than 1e-3
    int notFinite;            ///< bodies that end in NaN or infinity
};
RandomBodiesResult dropRandomBodies(const RandomBodiesDef& def);

}  // namespace bullet_buoyancy::scenes
