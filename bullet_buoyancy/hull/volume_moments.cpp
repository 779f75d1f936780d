#include "bullet_buoyancy/hull/volume_moments.h"

#include <Eigen/Geometry>

namespace bullet_buoyancy {

VolumeMoments volumeMoments(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return {};
    Vec3 apex = Vec3::Zero();
    for (const Vec3& vertex : mesh.vertices)
        apex += vertex / double(mesh.vertices.size());

    VolumeMoments moments;
    for (const Triangle& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle[0]] - apex;
        const Vec3 b = mesh.vertices[triangle[1]] - apex;
        const Vec3 c = mesh.vertices[triangle[2]] - apex;
        const double tetrahedron = a.dot(b.cross(c)) / 6;
        moments.volume += tetrahedron;
        const Vec3 sum = a + b + c;
        moments.firstMoment += tetrahedron * sum / 4;
        moments.secondMoment +=
            tetrahedron / 20 *
            (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    return moved(moments, apex);
}

VolumeMoments moved(const VolumeMoments& moments, const Vec3& offset) {
    const Mat3 cross = moments.firstMoment * offset.transpose();
    return {moments.volume, moments.firstMoment + moments.volume * offset,
            moments.secondMoment + cross + cross.transpose() + moments.volume * offset * offset.transpose()};
}

double surfaceArea(const TriangleMesh& mesh) {
    double area = 0;
    for (const Triangle& triangle : mesh.triangles) {
        const Vec3& a = mesh.vertices[triangle[0]];
        area += (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).norm() / 2;
    }
    return area;
}

}  // namespace bullet_buoyancy
