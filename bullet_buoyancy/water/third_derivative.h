#pragma once

#include <cmath>

namespace bullet_buoyancy {

/// Upper bound along any direction in the plane, of a function's third derivatives: by the inequality of
/// Cauchy and Schwarz with the direction's own third power.
inline double largestThirdDerivative(double xxx, double xxy, double xyy, double yyy) {
    return std::sqrt(xxx * xxx + 3 * (xxy * xxy + xyy * xyy) + yyy * yyy);
}

}  // namespace bullet_buoyancy
