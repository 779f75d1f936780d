#pragma once

#include "bullet_buoyancy/core/body_rows.h"

namespace bullet_buoyancy {

/// Water whose surface is level and stays where it is, world axes.
struct LevelWater {
    double up[3];
    double origin[3];      ///< a point of the surface, m
    double weightDensity;  ///< density times gravity, N/m^3
};

/// The closed hulls of a block of bodies, in each body's frame.
struct HullRows {
    VectorRows centre;  ///< of the sphere that bounds the hull, and origin of its packed mesh, m
    BodyRow radius;     ///< of that sphere, m
    BodyRow volume;     ///< of the hull, m^3
    VectorRows moment;  ///< of the position over that volume, m^4
};

/// The surface as each body sees it: see WaterPlane.
struct PlaneRows {
    VectorRows upInBody;
    BodyRow heightOfWater;
    BodyRow depthOfCentre;  ///< of the hull's, m
    BodyRow isCut;          ///< 1 where the surface may cut the hull, 0 where it is wholly dry or wet
};

/// See PressureSums.
struct PressureSumRows {
    BodyRow depth;
    VectorRows depthMoment;
};

/// See Displacement.
struct DisplacementRows {
    BodyRow volume;
    VectorRows volumeMoment;
    BodyRow headVolume, error;
};

}  // namespace bullet_buoyancy
