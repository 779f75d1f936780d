#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"

#include "bullet_buoyancy/hydrostatics/wet_triangle.h"

namespace bullet_buoyancy {

void addMesh(const TriangleMesh& mesh, const WaterPlane& plane, const HydrostaticQuery& query,
             WetIntegrals& integrals) {
    const Vec3& up = plane.upInBody;
    const auto corner = [&](std::uint32_t index) {
        const Vec3& position = mesh.vertices[index];
        return DepthPoint{position, plane.depth(position)};
    };
    for (const Triangle& triangle : mesh.triangles)
        visitWetPart(corner(triangle[0]), corner(triangle[1]), corner(triangle[2]),
                     [&](const DepthPoint& a, const DepthPoint& b, const DepthPoint& c) {
                         addWetTriangle(a, b, c, up, query, integrals);
                     });
}

}  // namespace bullet_buoyancy
