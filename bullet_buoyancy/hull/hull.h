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
    TriangleMesh mesh;  ///< all triangles: welded, outward
    PackedMesh packed;  ///< the same for kernels, about the centre of `bounds`
    std::vector<Sphere> spheres;
    std::vector<SolidOfRevolution> solids;

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

using HullPart = std::variant<TriangleMesh, Sphere, SolidOfRevolution>;

struct HullResult {
    std::shared_ptr<const Hull> hull;  ///< null if refused
    HullStatus status;
};

/// Repairs each mesh (see `repairMesh`), measures, and looks for parts that overlap.
HullResult makeHull(std::vector<HullPart> parts);
HullResult makeHull(TriangleMesh mesh);

}  // namespace bullet_buoyancy
