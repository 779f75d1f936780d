#pragma once

#include <limits>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

/// Where waves run: deep water by default.
struct WaterDepth {
    double depth = std::numeric_limits<double>::infinity();  ///< of the still water, m; above zero
    double gravity = standardGravity;                        ///< m/s^2; above zero
};

/// Linear dispersion relation at any depth (Airy 1845): frequency^2 = g k tanh(k depth). Arguments must not
/// be negative: asserted. Relative errors are below 1e-14. rad/s for 1/m.
///
/// At g = 9.81 m/s^2 waves of 8 s have a wavenumber of 0.0886224446 1/m in water of 10 m, 0.0707624287 1/m
/// in water of 20 m and 0.0628797426 1/m in deep water.
double frequencyOfWavenumber(double wavenumber, const WaterDepth& water = {});
/// The inverse, by Newton's method: 1/m for rad/s.
double wavenumberOfFrequency(double frequency, const WaterDepth& water = {});

}  // namespace bullet_buoyancy
