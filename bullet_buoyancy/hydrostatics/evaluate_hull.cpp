#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

#include "bullet_buoyancy/hydrostatics/in_waves.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateHull(const Hull& hull, const Pose& pose, const WaterField& water,
                               const HydrostaticQuery& query, MeshSum sum) {
    if (!water.bounds().isFlat()) {
        WetIntegrals integrals;
        const Vec3 pushes = addHullInWaves(hull, pose, water, query, sum, integrals);
        return toResult(integrals, pose, water, query, pushes);
    }
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    if (sum != MeshSum::oneByOne && isDisplacementAlone(hull, query))
        return toResult(displacementUnderPlane(hull, plane, sum, query.precision), pose, water, query);
    WetIntegrals integrals;
    integrals.samples = 1;
    addHullUnderPlane(hull, plane, sum, query, integrals);
    return toResult(integrals, pose, water, query, plane.upInBody);
}

}  // namespace bullet_buoyancy
