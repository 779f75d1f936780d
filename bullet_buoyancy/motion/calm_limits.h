#pragma once

// Shared with kernels: constants only.
namespace bullet_buoyancy {

/// Up to this turn in a step a body merely rocks, rad: 1.2 rad/s at 60 Hz. See turnGently.
inline constexpr double gentleTurn = 0.02;

/// From this product of rate and time on, the terms that the series of a DampedStep leaves out pass rounding.
inline constexpr double dampingSeriesEnds = 0.1;

/// See isAtRest.
inline constexpr double restFroudeNumber = 0.005, restImbalance = 1e-4;

}  // namespace bullet_buoyancy
