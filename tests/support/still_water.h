#pragma once

#include <Eigen/Geometry>

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

/// Fresh water whose surface is z = 0 of the world.
inline const FlatWater& stillWater() {
    static const FlatWater water(WaterFrame::zUp());
    return water;
}

/// Of that water, N/m^3.
inline constexpr double weightDensity = freshWaterDensity * standardGravity;

inline HydrostaticQuery everything() {
    HydrostaticQuery query;
    query.wettedArea = query.waterplane = true;
    return query;
}

inline HydrostaticResult inStillWater(const Hull& hull, const Pose& pose) {
    return evaluateExact(hull, pose, stillWater(), everything());
}

/// With the centre of mass at a height above the surface.
inline Pose atHeight(double height, const Eigen::Quaterniond& orientation = Eigen::Quaterniond::Identity()) {
    return {{0, 0, height}, orientation};
}

inline Eigen::Quaterniond turnedBy(double angle, const Vec3& axis) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

/// Turned at random, with the centre of its bounding sphere between so high and so deep that it just touches
/// the surface.
inline Pose atSurface(const Hull& hull, Random& random) {
    const Eigen::Quaterniond orientation = random.orientation();
    const double heightOfCentre = random.uniform(-1, 1) * hull.bounds.radius;
    return atHeight(heightOfCentre - (orientation * hull.bounds.centre).z(), orientation);
}

}  // namespace bullet_buoyancy::test
