#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"

#include "bullet_buoyancy/hydrostatics/reference_surface.h"
#include "bullet_buoyancy/hydrostatics/reference_volume.h"
#include "bullet_buoyancy/hydrostatics/reference_waves.h"
#include "bullet_buoyancy/hydrostatics/stiffness.h"

namespace bullet_buoyancy {

namespace {

HydrostaticResult evaluateInFlatWater(const Hull& hull, const Pose& pose, const WaterField& water,
                                      const HydrostaticQuery& query) {
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    WetIntegrals integrals;
    if (hull.meshIsClosed)
        addReferenceVolume(hull.mesh, plane, integrals);
    else
        addReferenceSurface(hull.mesh, plane, integrals);
    for (const Sphere& sphere : hull.spheres)
        addReferenceSurface(asSolidOfRevolution(sphere), plane, integrals);
    for (const SolidOfRevolution& solid : hull.solids)
        addReferenceSurface(solid, plane, integrals);
    return toResult(integrals, pose, water, query, plane.upInBody);
}

HydrostaticResult evaluateInWaves(const Hull& hull, const Pose& pose, const WaterField& water,
                                  const HydrostaticQuery& query) {
    WaterAroundBody aroundBody(pose, water, query);
    const ReferenceIntegrals integrals = integrateInWaves(hull, aroundBody);
    HydrostaticQuery withoutStiffness = query;
    withoutStiffness.stiffness = false;
    HydrostaticResult result = toResult(integrals.wet, pose, water, withoutStiffness, aroundBody.upInBody());
    const double weightDensity = water.density() * query.gravity;
    if (query.stiffness)
        result.stiffness = hydrostaticStiffness(
            result, aroundBody.surfaceGradientWorld(result.centreOfBuoyancyFromCom), weightDensity);
    result.forceErrorBound = weightDensity * integrals.error;
    result.waterSamples = aroundBody.samples();
    return result;
}

}  // namespace

HydrostaticResult evaluateReference(const Hull& hull, const Pose& pose, const WaterField& water,
                                    const HydrostaticQuery& query) {
    return water.bounds().isFlat() ? evaluateInFlatWater(hull, pose, water, query)
                                   : evaluateInWaves(hull, pose, water, query);
}

}  // namespace bullet_buoyancy
