#include "scenes/known_answers.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy::scenes {

namespace {

/// A floating body and its complement (ratio 1 - s, upside down) have the same stable tilts.
double mirrored(double ratio) {
    return std::min(ratio, 1 - ratio);
}

double tangentOfWallSidedTilt(double ratio) {
    return std::sqrt(std::max(0.0, 12 * ratio * (1 - ratio) - 2));
}

}  // namespace

double distanceFromLogThreshold(double ratio) {
    const double s = mirrored(ratio);
    return std::min(std::abs(s - logTiltsFrom), std::abs(s - logStandsOnEdgeFrom));
}

double squareLogTilt(double ratio) {
    const double s = mirrored(ratio);
    if (s <= logTiltsFrom) return 0;
    if (s >= logStandsOnEdgeFrom) return pi / 4;
    if (s <= 0.25) return std::atan(tangentOfWallSidedTilt(s));  // both lower edges wet
    const double root = std::sqrt(9 - 32 * s);                   // one edge wet
    return std::atan((3 - root) / (3 + root));
}

double squareLogCentreHeight(double ratio) {
    if (ratio > 0.5) return -squareLogCentreHeight(1 - ratio);
    const double tilt = squareLogTilt(ratio);
    if (ratio <= 0.25) return (0.5 - ratio) * std::cos(tilt);
    // The surface cuts off a corner with legs a, b from it: a b / 2 = ratio, b / a = tan(tilt).
    const double a = std::sqrt(2 * ratio / std::tan(tilt)), b = 2 * ratio / a;
    return (0.5 / a + 0.5 / b - 1) / std::hypot(1 / a, 1 / b);
}

double heavePeriod(double draft, double gravity) {
    return 2 * pi * std::sqrt(draft / gravity);
}

double cornerUpTilt() {
    return std::acos(1 / std::sqrt(3.0));
}

std::vector<CubeOrientation> stableCubeOrientations(double ratio) {
    constexpr double ringBreaksAt = 0.22654, towardsVertexUpTo = 0.2425;
    const double s = mirrored(ratio);
    std::vector<CubeOrientation> stable;
    if (s <= logTiltsFrom)
        stable.push_back({"face up", 0});
    else if (s <= ringBreaksAt)
        stable.push_back({"face tilted", std::atan(tangentOfWallSidedTilt(s))});
    else if (s <= towardsVertexUpTo)
        stable.push_back({"tilted towards a corner", -1});
    if (s > 1.0 / 6) stable.push_back({"corner up", cornerUpTilt()});
    return stable;
}

}  // namespace bullet_buoyancy::scenes
