#pragma once

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy::test {

/// Largest difference between two results, each quantity relative to what the whole hull would have: force to
/// the weight of water it displaces, moments and centres to that times the size of its bounding sphere.
inline double relativeDifference(const HydrostaticResult& a, const HydrostaticResult& b, const Hull& hull,
                                 double weightDensity) {
    const double volume = hull.moments.volume, size = hull.bounds.radius + hull.bounds.centre.norm();
    return std::max(
        {(a.forceWorld - b.forceWorld).norm() / (weightDensity * volume),
         (a.torqueAboutCom - b.torqueAboutCom).norm() / (weightDensity * volume * size),
         std::abs(a.submergedVolume - b.submergedVolume) / volume,
         (a.submergedVolume * a.centreOfBuoyancyFromCom - b.submergedVolume * b.centreOfBuoyancyFromCom)
                 .norm() /
             (volume * size),
         std::abs(a.potentialEnergy - b.potentialEnergy) / (weightDensity * volume * size)});
}

/// The same for the areas, relative to the square of the size.
inline double relativeAreaDifference(const HydrostaticResult& a, const HydrostaticResult& b,
                                     const Hull& hull) {
    const double size = hull.bounds.radius + hull.bounds.centre.norm(), area = size * size;
    return std::max({std::abs(a.wettedArea - b.wettedArea) / area,
                     std::abs(a.waterplane.area - b.waterplane.area) / area,
                     (a.waterplane.firstMoment - b.waterplane.firstMoment).norm() / (area * size),
                     (a.waterplane.secondMoment - b.waterplane.secondMoment).norm() / (area * size * size)});
}

/// The same for the stiffness of both, relative to what a waterplane of the square of the size would have.
inline double relativeStiffnessDifference(const HydrostaticResult& a, const HydrostaticResult& b,
                                          const Hull& hull, double weightDensity) {
    const double size = hull.bounds.radius + hull.bounds.centre.norm();
    Mat6 perSize = Mat6::Identity();
    perSize.diagonal().tail<3>().setConstant(1 / size);
    const Mat6 difference = perSize * (*a.stiffness - *b.stiffness) * perSize;
    return difference.norm() / (weightDensity * size * size);
}

}  // namespace bullet_buoyancy::test
