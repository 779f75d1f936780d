#pragma once

#include <memory>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy::scenes {

/// How a boat is laden.
struct LadingDef {
    double displacement = 1;                ///< at rest, m^3: above zero and below the hull's volume
    double waterDensity = seaWaterDensity;  ///< kg/m^3
    double pitchGyration = 0.25;            ///< radius of gyration in pitch and in yaw, lengths
    double rollGyration = 0.35;             ///< in roll, beams
    double metacentricHeight = 0.1;         ///< wanted, beams
    double highestCentre = 0.6;  ///< the centre of gravity is not above that share of the hull's depth
};

/// A hull that floats upright and level, with its masses. Body axes: x to the bow, y to port, z up, from the
/// centre of mass.
struct Boat {
    std::shared_ptr<const Hull> hull;    ///< null if refused: see `status`
    HullStatus status;                   ///< of the hull
    double mass = 0;                     ///< kg
    Vec3 inertia = Vec3::Zero();         ///< about the body axes, kg m^2
    Vec3 size = Vec3::Zero();            ///< length, beam, depth from keel to the highest point, m
    double draft = 0;                    ///< m
    double displacement = 0;             ///< m^3
    double waterplaneArea = 0;           ///< m^2
    double heightAtRest = 0;             ///< of the centre of mass above the water, m
    double centreOfBuoyancyAtRest = 0;   ///< its height above the water, m
    double metacentricHeight = 0;        ///< in roll, m
    double longitudinalMetacentric = 0;  ///< metacentric height in pitch, m

    /// Natural periods without added mass, s; NaN where it would not stay upright.
    double heavePeriod(double gravity = standardGravity) const;
    double pitchPeriod(double gravity = standardGravity) const;
    double rollPeriod(double gravity = standardGravity) const;
};

/// The boat with the hull `mesh` (x to the bow, z up, any origin). Its centre of gravity lies above or below
/// the centre of buoyancy, so that it floats level, at the height that gives the metacentric height wanted.
Boat makeBoat(const TriangleMesh& mesh, const LadingDef& lading);

/// What the mesh displaces (m^3) with the plane z = 0 as the water's surface.
double displacementBelowOrigin(const TriangleMesh& mesh);

}  // namespace bullet_buoyancy::scenes
