#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

#include "bullet_buoyancy/hydrostatics/in_waves.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateHull(const Hull& hull, const Pose& pose, const WaterField& water,
                               const HydrostaticQuery& query, MeshSum sum) {
    WetIntegrals integrals;
    if (!water.bounds().isFlat())
        return toResult(integrals, pose, water, query,
                        addHullInWaves(hull, pose, water, query, sum, integrals));
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    integrals.samples = 1;
    addHullUnderPlane(hull, plane, sum, query, integrals);
    return toResult(integrals, pose, water, query, plane.upInBody);
}

}  // namespace bullet_buoyancy
