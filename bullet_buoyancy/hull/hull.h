#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "bullet_buoyancy/hull/hull_status.h"
#include "bullet_buoyancy/hull/packed_mesh.h"
#include "bullet_buoyancy/hull/solid_of_revolution.h"
#include "bullet_buoyancy/hull/sphere.h"
#include "bullet_buoyancy/hull/surface_moments.h"

namespace bullet_buoyancy {

/// What the water can wet of a body, in the body's frame, whose origin is its centre of mass. Made once by
/// `makeHull`, never changed, shared by as many bodies as have the shape.
struct Hull {
    TriangleMesh mesh;                      ///< all triangles: welded, outward
    PackedMesh packed;                      ///< the same for kernels, about the centre of `bounds`
    std::vector<Sphere> spheres;            ///< as true spheres, not tessellated
    std::vector<SolidOfRevolution> solids;  ///< likewise: capsules, cylinders, cones

    bool meshIsClosed = true;  ///< no edge of `mesh` is open: what it encloses is well defined
    VolumeMoments
        moments;  ///< of everything, overlaps as often as they are; see `volumeMoments` for open meshes
    double surfaceArea = 0;  ///< of everything, m^2
    SurfaceMoments
        surface;    ///< of everything, curved parts roughly: to estimate from above, not to integrate
    Sphere bounds;  ///< encloses everything
    Vec3 halfExtents =
        Vec3::Zero();  ///< of the box along the body's axes that encloses everything, about the same centre
};

/// What hulls are made of, in the body's frame; meshes should be closed.
using HullPart = std::variant<TriangleMesh, Sphere, SolidOfRevolution>;

/// A hull, or why there is none.
struct HullResult {
    std::shared_ptr<const Hull> hull;  ///< null if refused
    HullStatus status;                 ///< refusal or remarks
};

/// Repairs each mesh, measures, and looks for parts that overlap; tells in the status what it found. Vertices
/// nearer than `weldTolerance` of the mesh's size become one, neighbours agree in their winding, outermost
/// shells face outward: see HullStatus. Takes time and memory: not for every step.
HullResult makeHull(std::vector<HullPart> parts);
/// The same of a single mesh.
HullResult makeHull(TriangleMesh mesh);

}  // namespace bullet_buoyancy
