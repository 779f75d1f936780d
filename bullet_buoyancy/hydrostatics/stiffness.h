#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// How the water's force and torque answer to a small displacement (rows and columns 0-2, m) and rotation
/// about the centre of mass (3-5, rad) in world axes: (force, torque) changes by -K times (displacement,
/// rotation). Heave, roll and pitch as a naval architect knows them, plus the moment arm of the centre of
/// buoyancy, which may be destabilising. Gravity, which acts at the centre of mass, adds nothing. With rho g
/// `weightDensity` (N/m^3) and n up, it is rho g integral over the waterplane of (n; r x n)(n; r x n)^T dA,
/// plus rho g V ((rB.n) 1 - rB n^T) on the rotations. In waves n is minus the gradient of the head, longer
/// than 1 where the surface slopes, and the waterplane that in plan; the surface's bend is left out.
///
/// `result` must have been asked for its waterplane, of a closed hull. Not symmetric where rB is not above or
/// below the centre of mass: there the body is not in equilibrium.
Mat6 hydrostaticStiffness(const HydrostaticResult& result, const Vec3& pushesWorld, double weightDensity);

}  // namespace bullet_buoyancy
