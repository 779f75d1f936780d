#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"

#include "bullet_buoyancy/hydrostatics/in_waves.h"
#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"

namespace bullet_buoyancy {

namespace {

/// Returns the vertical.
Vec3 addHullInFlatWater(const Hull& hull, const Pose& pose, const WaterField& water,
                        const HydrostaticQuery& query, WetIntegrals& integrals) {
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    integrals.samples = 1;
    const double depthOfCentre = plane.depth(hull.bounds.centre);
    if (depthOfCentre <= -hull.bounds.radius) return plane.upInBody;
    if (depthOfCentre >= hull.bounds.radius && hull.meshIsClosed) {
        const VolumeMoments& all = hull.moments;
        integrals.addDisplacement(plane.upInBody, all.volume, all.firstMoment,
                                  plane.heightOfWater * all.volume - plane.upInBody.dot(all.firstMoment));
        integrals.wettedArea = query.wettedArea ? hull.surfaceArea : 0;
    } else {
        addMesh(hull.mesh, plane, query, integrals);
        for (const Sphere& sphere : hull.spheres)
            addSphere(sphere, plane, query, integrals);
        for (const SolidOfRevolution& solid : hull.solids)
            addSolid(solid, plane, query, integrals);
    }
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
