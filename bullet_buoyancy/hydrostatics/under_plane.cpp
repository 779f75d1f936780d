#include "bullet_buoyancy/hydrostatics/under_plane.h"

#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"
#include "bullet_buoyancy/hydrostatics/packed_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"

namespace bullet_buoyancy {

namespace {

bool isDry(const Hull& hull, const WaterPlane& plane) {
    return plane.depth(hull.bounds.centre) <= -hull.bounds.radius;
}

bool isUnder(const Hull& hull, const WaterPlane& plane) {
    return hull.meshIsClosed && plane.depth(hull.bounds.centre) >= hull.bounds.radius;
}

Displacement allOf(const Hull& hull, const WaterPlane& plane) {
    const VolumeMoments& all = hull.moments;
    return {all.volume, all.firstMoment,
            plane.heightOfWater * all.volume - plane.upInBody.dot(all.firstMoment)};
}

}  // namespace

void addHullUnderPlane(const Hull& hull, const WaterPlane& plane, MeshSum sum, const HydrostaticQuery& query,
                       WetIntegrals& integrals) {
    if (isDry(hull, plane)) return;
    if (isUnder(hull, plane)) {
        integrals.addDisplacement(plane.upInBody, allOf(hull, plane));
        if (query.wettedArea) integrals.wettedArea += hull.surfaceArea;
        return;
    }
    if (sum == MeshSum::oneByOne || !hull.meshIsClosed)
        addMesh(hull.mesh, plane, query, integrals);
    else if (!hull.mesh.triangles.empty())
        addPackedMesh(hull.packed, plane, sum, query, integrals);
    for (const Sphere& sphere : hull.spheres)
        addSphere(sphere, plane, query, integrals);
    for (const SolidOfRevolution& solid : hull.solids)
        addSolid(solid, plane, query, integrals);
}

bool isDisplacementAlone(const Hull& hull, const HydrostaticQuery& query) {
    return hull.meshIsClosed && hull.solids.empty() && !query.needsWaterplane() && !query.wettedArea;
}

Displacement displacementUnderPlane(const Hull& hull, const WaterPlane& plane, MeshSum sum,
                                    Precision precision) {
    if (isDry(hull, plane)) return {};
    if (isUnder(hull, plane)) return allOf(hull, plane);
    if (hull.spheres.empty()) return displacementOf(hull.packed, plane, sum, precision);
    Displacement displaced;
    if (!hull.mesh.triangles.empty()) displaced += displacementOf(hull.packed, plane, sum, precision);
    for (const Sphere& sphere : hull.spheres)
        displaced += displacementOf(sphere, plane);
    return displaced;
}

}  // namespace bullet_buoyancy
