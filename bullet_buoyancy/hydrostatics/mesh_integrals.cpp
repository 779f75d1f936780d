#include "bullet_buoyancy/hydrostatics/mesh_integrals.h"

#include <Eigen/Geometry>

#include "bullet_buoyancy/hydrostatics/clip_triangle.h"

namespace bullet_buoyancy {

namespace {

/// A wholly wet triangle. For linear functions f and g over a triangle of area A, the integral of f g is
/// A/12 ((sum f)(sum g) + sum f_i g_i). Volumes by the divergence theorem with fields that vanish at depth 0,
/// so that the waterplane adds nothing.
void addPressure(const DepthPoint& a, const DepthPoint& b, const DepthPoint& c, const Vec3& up,
                 WetIntegrals& integrals) {
    const Vec3 areaVector = (b.position - a.position).cross(c.position - a.position) / 2;
    const double sumDepth = a.depth + b.depth + c.depth;
    const Vec3 sumPosition = a.position + b.position + c.position;
    const Vec3 depthMoment =
        (sumDepth * sumPosition + a.depth * a.position + b.depth * b.position + c.depth * c.position) / 12;
    const double depthSquared =
        (sumDepth * sumDepth + a.depth * a.depth + b.depth * b.depth + c.depth * c.depth) / 12;
    const double areaUp = areaVector.dot(up);

    integrals.depthNormal += sumDepth / 3 * areaVector;
    integrals.depthTorque += depthMoment.cross(areaVector);
    integrals.volume -= sumDepth / 3 * areaUp;
    integrals.volumeMoment -= areaUp * (depthMoment + depthSquared / 2 * up);
    integrals.depthVolume -= depthSquared / 2 * areaUp;
}

/// The shadow that a wet triangle throws straight up on the water's surface, negative where it faces up: over
/// a closed hull they sum to the waterplane.
void addShadow(const DepthPoint& a, const DepthPoint& b, const DepthPoint& c, const Vec3& up,
               Waterplane& waterplane) {
    const double area = -(b.position - a.position).cross(c.position - a.position).dot(up) / 2;
    const Vec3 pa = a.position + a.depth * up, pb = b.position + b.depth * up, pc = c.position + c.depth * up;
    const Vec3 sum = pa + pb + pc;
    waterplane.area += area;
    waterplane.firstMoment += area / 3 * sum;
    waterplane.secondMoment +=
        area / 12 * (sum * sum.transpose() + pa * pa.transpose() + pb * pb.transpose() + pc * pc.transpose());
}

}  // namespace

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
                         addPressure(a, b, c, up, integrals);
                         if (query.wettedArea)
                             integrals.wettedArea +=
                                 (b.position - a.position).cross(c.position - a.position).norm() / 2;
                         if (query.waterplane) addShadow(a, b, c, up, integrals.waterplane);
                     });
}

}  // namespace bullet_buoyancy
