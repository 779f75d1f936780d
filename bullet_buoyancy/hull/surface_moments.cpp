#include "bullet_buoyancy/hull/surface_moments.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

/// The one by the axes' parts, exact for boxes, the other by Cauchy and Schwarz.
double SurfaceMoments::shadowAlong(const Vec3& direction) const {
    return std::min(shadows.dot(direction.cwiseAbs()),
                    std::sqrt(area * direction.dot(orientation * direction)) / 2);
}

double SurfaceMoments::largestSection() const {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(orientation, Eigen::EigenvaluesOnly);
    return std::sqrt(area * solver.eigenvalues()[2]) / 2;
}

Vec3 SurfaceMoments::largestSecondMoments() const {
    return (Vec3::Constant(position.trace()) - position.diagonal()) / 2;
}

SurfaceMoments& SurfaceMoments::operator+=(const SurfaceMoments& other) {
    area += other.area;
    position += other.position;
    orientation += other.orientation;
    shadows += other.shadows;
    return *this;
}

SurfaceMoments surfaceMoments(const TriangleMesh& mesh) {
    SurfaceMoments moments;
    for (const Triangle& triangle : mesh.triangles) {
        const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                   &c = mesh.vertices[triangle[2]];
        const Vec3 areaVector = (b - a).cross(c - a) / 2, sum = a + b + c;
        const double area = areaVector.norm();
        if (area == 0) continue;
        moments.area += area;
        moments.position +=
            area / 12 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
        moments.orientation += areaVector * areaVector.transpose() / area;
        moments.shadows += areaVector.cwiseAbs() / 2;
    }
    return moments;
}

}  // namespace bullet_buoyancy
