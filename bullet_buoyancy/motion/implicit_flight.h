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
    Load load;                        ///< at the pose when the step begins
    Mat6 stiffness;                   ///< see LoadField; at the pose when the step ends
    double turnLimit;                 ///< see `fly`
    const Load* loadAhead = nullptr;  ///< at the pose when the step ends; null: `load`, in a calm field
};

/// The step of `dt` (s) with the load at its end: the velocity and spin u of the flight minimise the
/// incremental potential
///     1/2 (u - u_explicit)^T M (u - u_explicit) dt / gain + potential(pose moved by dt u),
/// by Newton's method with the stiffness and a line search on that potential (Ortiz and Stainier 1999; Martin
/// et al. 2011), that of the field when the step ends. It begins from rest, or in a calm field from rest
/// along `up`, where that potential is known, so that the flight ends no higher than the energy of the start
/// and the work of the field at its pose allow, whatever is met on the way.
Flight flyImplicitly(const FlightStart& start, const Inertia& inertia, double implicitness, double dt,
                     const LoadField& ahead);

}  // namespace bullet_buoyancy
