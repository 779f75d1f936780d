#pragma once

#include <memory>
#include <string>

#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/water/water_field.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

/// A sea for bodies of about 1 m, and what it is made of.
struct RandomSea {
    std::string kind;
    std::shared_ptr<const WaterField> water;
};

/// Of the nine kinds number `kind` modulo nine: regular, long- and short-crested Airy waves, JONSWAP,
/// trochoids, shallow water, swell with wind sea and current, a grid of heights, a function. Waves of 4 to 60
/// m, up to a steepness (the sum of amplitudes times wavenumbers) of 0.4.
RandomSea randomSea(std::size_t kind, Random& random);

/// Turned at random, with its bounding sphere across the surface of the water at that time (s), anywhere
/// within 100 m of the frame's origin.
Pose poseAcross(const WaterField& water, const Hull& hull, double time, Random& random);

}  // namespace bullet_buoyancy::test
