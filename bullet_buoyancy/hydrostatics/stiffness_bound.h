#pragma once

#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy {

/// The stiffest that a hull can be in water, however it lies: from the size of its surface, before its
/// waterplane is known. An estimate from above, by a factor of up to three in the rotations; twisted hulls
/// may pass it.
struct StiffnessBound {
    double heave;      ///< N/m
    Vec3 perAxisTurn;  ///< about the body's axes, N m/rad
};

/// `weightDensity`: rho g, N/m^3.
inline StiffnessBound stiffnessBound(const Hull& hull, double weightDensity) {
    return {weightDensity * hull.surface.largestSection(),
            weightDensity * hull.surface.largestSecondMoments()};
}

}  // namespace bullet_buoyancy
