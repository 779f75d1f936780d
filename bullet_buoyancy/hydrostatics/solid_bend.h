#pragma once

#include "bullet_buoyancy/hydrostatics/solid_sections.h"
#include "bullet_buoyancy/hydrostatics/tangent_water.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// By how much water to second order departs from its tangent water, as functions of the offset from `about`.
struct BentWater {
    Vec3 about;
    Quadratic depth, head;

    BentWater(const WaterExpansion& water, const TangentWater& tangent, const Vec3& about);
};

/// What is to be known of a solid in bent water for a bound.
struct BendSummary {
    double atWaterline = 0;     ///< largest departure along the tangent water's waterline, m
    Vec3 error = Vec3::Zero();  ///< of the expansion, over the wet surface, m^3
};

/// Adds what the bend does to the part of a solid that the tangent water leaves wet, by the divergence
/// theorem: from moments of that part's volume and of its lid in the waterplane. What the bend wets or lays
/// bare counts in the volumes, of the force it is of the second order.
BendSummary addBend(const SolidOfRevolution& solid, const WaterPatch& water, const WaterExpansion& expansion,
                    const TangentWater& tangent, const BentWater& bent, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
