#include "bullet_buoyancy/hull/winding_number.h"

#include <Eigen/Geometry>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

double windingNumber(const TriangleMesh& mesh, const Vec3& point) {
    double halfSolidAngles = 0;
    for (const Triangle& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle[0]] - point;
        const Vec3 b = mesh.vertices[triangle[1]] - point;
        const Vec3 c = mesh.vertices[triangle[2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        halfSolidAngles +=
            std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return halfSolidAngles / (2 * pi);
}

}  // namespace bullet_buoyancy
