#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"

#include "bullet_buoyancy/hydrostatics/in_waves.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"

namespace bullet_buoyancy {

namespace {

/// Returns the vertical.
Vec3 addHullInFlatWater(const Hull& hull, const Pose& pose, const WaterField& water,
                        const HydrostaticQuery& query, WetIntegrals& integrals) {
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    integrals.samples = 1;
    addHullUnderPlane(hull, plane, query, integrals);
    return plane.upInBody;
}

}  // namespace

HydrostaticResult evaluateExact(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& asked) {
    const HydrostaticQuery query = withPrerequisites(asked);
    WetIntegrals integrals;
    const Vec3 pushes = water.bounds().isFlat() ? addHullInFlatWater(hull, pose, water, query, integrals)
                                                : addHullInWaves(hull, pose, water, query, integrals);
    return toResult(integrals, pose, water, query, pushes);
}

}  // namespace bullet_buoyancy
