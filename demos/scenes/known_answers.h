#pragma once

#include <string>
#include <vector>

namespace bullet_buoyancy::scenes {

/// Closed forms for bodies that float at rest. Density ratios are body over water, between 0 and 1; angles in
/// radians.

/// Ratios at which a square log begins to tilt, and at which it has reached 45 degrees; mirrored (1 - ratio)
/// above 1/2.
inline constexpr double logTiltsFrom = 0.21132486540518713;  // (3 - sqrt 3) / 6
inline constexpr double logStandsOnEdgeFrom = 0.28125;       // 9 / 32

/// Distance of a ratio from the nearest of the log's four thresholds.
double distanceFromLogThreshold(double ratio);

/// Tilt of a face of a long square log from the horizontal, 0 to pi/4 (Reid 1963; Gilbert 1991).
double squareLogTilt(double ratio);

/// Height of the log's centre above the water in units of its side, where it floats at that tilt.
double squareLogCentreHeight(double ratio);

/// Period of small heave of a wall-sided body of given draft (m) under gravity (m/s^2), without added mass,
/// s.
double heavePeriod(double draft, double gravity);

/// A way in which a homogeneous cube can float.
struct CubeOrientation {
    std::string name;
    double tilt;  ///< of the cube's axis that is nearest to the vertical, from the vertical; below 0: not
                  ///< known in closed form
};

/// The stable ones at a density ratio. Where two are stable, a release may end in either.
std::vector<CubeOrientation> stableCubeOrientations(double ratio);

/// Tilt of a cube that stands on a corner, acos(1 / sqrt 3).
double cornerUpTilt();

}  // namespace bullet_buoyancy::scenes
