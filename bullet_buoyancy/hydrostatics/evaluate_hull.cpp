#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

#include "bullet_buoyancy/hydrostatics/in_waves.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateHull(const Hull& hull, const Pose& pose, const WaterField& water,
                               const HydrostaticQuery& query, MeshSum sum) {
    const WaterBounds bounds = water.bounds();
    if (!bounds.isFlat()) {
        WetIntegrals integrals;
        const Vec3 pushes = addHullInWaves(hull, pose, water, query, sum, integrals);
        return toResult(integrals, pose, water, query, pushes);
    }
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    const int samples = bounds.isLevel() ? 0 : 1;
    if (sum != MeshSum::oneByOne && isDisplacementAlone(hull, query)) {
        HydrostaticResult result =
            toResult(displacementUnderPlane(hull, plane, sum, query.precision), pose, water, query);
        result.waterSamples = samples;
        return result;
    }
    WetIntegrals integrals;
    integrals.samples = samples;
    addHullUnderPlane(hull, plane, sum, query, integrals);
    return toResult(integrals, pose, water, query, plane.upInBody);
}

}  // namespace bullet_buoyancy
