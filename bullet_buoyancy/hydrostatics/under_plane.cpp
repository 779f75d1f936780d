#include "bullet_buoyancy/hydrostatics/under_plane.h"

#include <limits>

#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"
#include "bullet_buoyancy/hydrostatics/packed_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"

namespace bullet_buoyancy {

namespace {

/// Corners, depths and areas are rounded to 6e-8 of themselves each.
double roundingOfSingle(const Hull& hull) {
    return 4 * double(std::numeric_limits<float>::epsilon()) * hull.surfaceArea * hull.bounds.radius;
}

void addWhole(const Hull& hull, const WaterPlane& plane, const HydrostaticQuery& query,
              WetIntegrals& integrals) {
    const VolumeMoments& all = hull.moments;
    integrals.addDisplacement(plane.upInBody, all.volume, all.firstMoment,
                              plane.heightOfWater * all.volume - plane.upInBody.dot(all.firstMoment));
    if (query.wettedArea) integrals.wettedArea += hull.surfaceArea;
}

}  // namespace

void addHullUnderPlane(const Hull& hull, const WaterPlane& plane, MeshSum sum, const HydrostaticQuery& query,
                       WetIntegrals& integrals) {
    const double depthOfCentre = plane.depth(hull.bounds.centre);
    if (depthOfCentre <= -hull.bounds.radius) return;
    if (depthOfCentre >= hull.bounds.radius && hull.meshIsClosed)
        return addWhole(hull, plane, query, integrals);
    if (sum == MeshSum::oneByOne || !hull.meshIsClosed) {
        addMesh(hull.mesh, plane, query, integrals);
    } else if (!hull.mesh.triangles.empty()) {
        addPackedMesh(hull.packed, plane, sum, query, integrals);
        if (query.precision == Precision::single)
            integrals.error += roundingOfSingle(hull) * plane.upInBody.cwiseAbs();
    }
    for (const Sphere& sphere : hull.spheres)
        addSphere(sphere, plane, query, integrals);
    for (const SolidOfRevolution& solid : hull.solids)
        addSolid(solid, plane, query, integrals);
}

}  // namespace bullet_buoyancy
