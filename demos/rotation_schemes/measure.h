#pragma once

#include <string>

#include "bullet_buoyancy/core/math_types.h"
#include "rotation_schemes/schemes.h"

namespace bullet_buoyancy::demo {

/// A homogeneous box that is set spinning.
struct SpinCase {
    std::string name;
    Vec3 halfExtents;  ///< m
    Vec3 spin;         ///< in its own axes, rad/s

    /// Moments of inertia of the box if its mass is 1 kg, kg m^2.
    Vec3 principal() const;
    Tumbler start() const;
};

/// The largest errors on the way.
struct SchemeError {
    double orientation = 0;  ///< rad
    double energy = 0;       ///< relative
    double momentum = 0;     ///< of its length, relative
};

/// Against Taylor series in the longest floating-point numbers that there are, with steps a quarter as long.
SchemeError measureError(const Scheme& scheme, const SpinCase& spin, double dt, double seconds);

/// Nanoseconds a step: the median of several blocks, each of so many steps.
double measureTime(const Scheme& scheme, const SpinCase& spin, double dt, int stepsInABlock);

}  // namespace bullet_buoyancy::demo
