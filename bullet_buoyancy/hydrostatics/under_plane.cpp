#include "bullet_buoyancy/hydrostatics/under_plane.h"

#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"

namespace bullet_buoyancy {

void addHullUnderPlane(const Hull& hull, const WaterPlane& plane, const HydrostaticQuery& query,
                       WetIntegrals& integrals) {
    const double depthOfCentre = plane.depth(hull.bounds.centre);
    if (depthOfCentre <= -hull.bounds.radius) return;
    if (depthOfCentre >= hull.bounds.radius && hull.meshIsClosed) {
        const VolumeMoments& all = hull.moments;
        integrals.addDisplacement(plane.upInBody, all.volume, all.firstMoment,
                                  plane.heightOfWater * all.volume - plane.upInBody.dot(all.firstMoment));
        integrals.wettedArea += query.wettedArea ? hull.surfaceArea : 0;
        return;
    }
    addMesh(hull.mesh, plane, query, integrals);
    for (const Sphere& sphere : hull.spheres)
        addSphere(sphere, plane, query, integrals);
    for (const SolidOfRevolution& solid : hull.solids)
        addSolid(solid, plane, query, integrals);
}

}  // namespace bullet_buoyancy
