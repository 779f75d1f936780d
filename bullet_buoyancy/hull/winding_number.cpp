#include "bullet_buoyancy/hull/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
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

bool encloses(const TriangleMesh& outer, const TriangleMesh& inner) {
    const std::size_t stride = 1 + inner.triangles.size() / 32;
    double excess = 0;  // at several places, for where the two touch the winding number is a half
    for (std::size_t t = 0; t < inner.triangles.size(); t += stride) {
        const Triangle& triangle = inner.triangles[t];
        const Vec3 centroid =
            (inner.vertices[triangle[0]] + inner.vertices[triangle[1]] + inner.vertices[triangle[2]]) / 3;
        excess += std::min(1.0, std::abs(windingNumber(outer, centroid))) - 0.5;
    }
    constexpr double rounding = 1e-9;  // half within is not most
    return excess > rounding;
}

}  // namespace bullet_buoyancy
