#pragma once

#include <vector>

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::scenes {

/// A moment at which a hull lies across the surface of the water.
struct StudyCase {
    Pose pose;
    Pose inFlatWater;  ///< the same, as high above the plane z = 0
    double time;       ///< s
};

/// At random (fixed seed), of all attitudes; in flat water 1 to 99 % of the hull would be wet. The water's
/// frame is z up.
std::vector<StudyCase> casesAcross(const WaterField& water, const Hull& hull, int count);

/// Height of the surface over a point x, y of the water's frame, m.
double elevationAt(const WaterField& water, const Vec2& place, double time);

}  // namespace bullet_buoyancy::scenes
