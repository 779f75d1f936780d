#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"

#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateExact(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& asked) {
    const HydrostaticQuery query = withPrerequisites(asked);
    const WaterPlane plane = waterPlaneInBody(water, pose, query.time);
    const double depthOfCentre = plane.depth(hull.bounds.centre);
    WetIntegrals integrals;
    if (depthOfCentre <= -hull.bounds.radius) return toResult(integrals, pose, water, query);
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
    return toResult(integrals, pose, water, query);
}

}  // namespace bullet_buoyancy
