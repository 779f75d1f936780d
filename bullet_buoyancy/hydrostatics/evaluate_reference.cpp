#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"

#include "bullet_buoyancy/hydrostatics/reference_surface.h"
#include "bullet_buoyancy/hydrostatics/reference_volume.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateReference(const Hull& hull, const Pose& pose, const WaterField& water,
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

}  // namespace bullet_buoyancy
