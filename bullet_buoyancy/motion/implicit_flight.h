#pragma once

#include "bullet_buoyancy/motion/kick.h"

namespace bullet_buoyancy {

/// How a body leaves one pose, and where it arrives after a step.
struct Flight {
    Motion departure;
    Motion arrival;          ///< before the kick that ends the step
    Load load;               ///< at the arrival's pose
    Dissipation dissipated;  ///< by the kick that begins the step
    int evaluations = 0;     ///< of the load
};

/// The loads of the two kicks of a step, as weights of the load at its start and of that at its end: from the
/// trapezoidal rule (`implicitness` 0: keeps the energy of a linear oscillation at any step) to implicit
/// Euler (1: damps whatever is faster than the step).
struct KickWeights {
    double firstOfStart, firstOfEnd, lastOfStart, lastOfEnd;

    explicit KickWeights(double implicitness)
        : firstOfStart((1 - implicitness) / 2),
          firstOfEnd((1 + 3 * implicitness) / 2),
          lastOfStart(firstOfStart),
          lastOfEnd(firstOfStart) {}
};

/// Where a step begins, and what is known there.
struct FlightStart {
    Motion motion;
    Load load;
    Mat6 stiffness;    ///< see LoadField
    double turnLimit;  ///< see `fly`
};

/// The step of `dt` (s) with the load at its end: the velocity and spin u of the flight minimise the
/// incremental potential
///     1/2 (u - u_explicit)^T M (u - u_explicit) dt / gain + potential(pose moved by dt u),
/// by Newton's method with the stiffness and a line search on that potential (Ortiz and Stainier 1999; Martin
/// et al. 2011). It begins from rest along `up`, where the potential is that of the start, so that the flight
/// ends no higher than the energy of the start allows, whatever is met on the way.
Flight flyImplicitly(const FlightStart& start, const Inertia& inertia, double implicitness, double dt,
                     const LoadField& field);

}  // namespace bullet_buoyancy
