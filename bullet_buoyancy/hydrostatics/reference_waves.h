#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"
#include "bullet_buoyancy/hydrostatics/reference_water.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// How far the integrals may be from the truth: of volume and force over the hull's volume, of moments and
/// energy over that times the size of the hull seen from its centre of mass; of wetted area and waterplane
/// over the powers of that size.
struct ReferenceTolerance {
    double pressure = 1e-8;
    double areas = 1e-6;
};

struct ReferenceIntegrals {
    WetIntegrals wet;
    double error = 0;  ///< of the force before density and gravity, estimated from above, m^3
};

/// What waves do to a hull, open or closed, by pressure over its surface: cells of its patches are quartered,
/// the worst one first, until the sum of their errors is within the tolerance. Gives up after some ten
/// thousand cells, where a face or a line of the hull so nearly coincides with the surface that what is wet
/// cannot be told: then areas are wrong, the force hardly, and `error` says by how much.
ReferenceIntegrals integrateInWaves(const Hull& hull, WaterAroundBody& water,
                                    const ReferenceTolerance& tolerance = {});

}  // namespace bullet_buoyancy
