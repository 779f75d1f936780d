#pragma once

#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::test {

/// Random poses a hull is put into: the build's BULLET_BUOYANCY_TEST_POSES.
int posesAHull();

/// Largest difference of two evaluators.
struct WorstDifference {
    double pressure = 0;  ///< see `relativeDifference`
    double areas = 0;     ///< see `relativeAreaDifference` and `relativeStiffnessDifference`
};

/// Between `evaluateExact` and `evaluateReference`, over random poses (fixed seed) at which the hull's
/// bounding sphere reaches the surface, near a given place on the water in its frame.
WorstDifference worstDifference(const Hull& hull, const WaterField& water, const Vec3& placeInFrame,
                                int poses);

}  // namespace bullet_buoyancy::test
