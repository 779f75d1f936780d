#pragma once

namespace bullet_buoyancy::scenes {

/// How a scene is stepped.
struct Stepping {
    double dt = 1.0 / 60;  ///< of one stepSimulation, s
    int substeps = 1;
};

struct LogResult {
    double ratio;         ///< density over the water's
    double tilt;          ///< of the face that is nearest to the horizontal, 0 to pi/4
    double centreHeight;  ///< above the water, in units of the side
    double settledAfter;  ///< simulated seconds until it was at rest; the limit if it never was
};

/// Lets a square log (1 m by 1 m by 8 m), released at a tilt, settle in damped water.
LogResult floatLog(double ratio, const Stepping& stepping = {});

/// The density ratio between `low` and `high` at which the settled tilt passes `tilt` (radians), to 0.001 by
/// bisection.
double findLogThreshold(double low, double high, double tilt, const Stepping& stepping = {});

}  // namespace bullet_buoyancy::scenes
