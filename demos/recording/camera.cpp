#include "recording/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bullet_buoyancy::recording {

namespace {

/// Where points are in the picture if the camera is `distance` (m) from the target: left, right, bottom, top,
/// in units of half its width.
Eigen::Array4d extents(const std::vector<Vec3>& points, const Camera& camera, const Mat3& axes) {
    Eigen::Array4d edges(1e9, -1e9, 1e9, -1e9);
    for (const Vec3& point : points) {
        const Vec3 seen = axes.transpose() * (point - camera.position);
        const double x = seen.x() / seen.z() / camera.tangent, y = seen.y() / seen.z() / camera.tangent;
        edges << std::min(edges[0], x), std::max(edges[1], x), std::min(edges[2], y), std::max(edges[3], y);
    }
    return edges;
}

}  // namespace

Camera aimCamera(const std::vector<Vec3>& points, double azimuth, double elevation, double aspect) {
    constexpr double margin = 0.96;
    Camera camera{Vec3::Zero(), Vec3::Zero(), 0.27};
    Mat3 axes;  // right, up, forward
    axes.col(2) = -Vec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                        std::cos(elevation) * std::cos(azimuth));
    axes.col(0) = axes.col(2).cross(Vec3::UnitY()).normalized();
    axes.col(1) = axes.col(0).cross(axes.col(2));
    Vec3 low = points.front(), high = low;
    for (const Vec3& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    camera.target = (low + high) / 2;
    double distance = 3 * (high - low).norm() + 1e-3;
    // Comes nearer and centres what it sees, by turns: each makes up for what the other spoils.
    for (int i = 0; i < 20; ++i) {
        camera.position = camera.target - distance * axes.col(2);
        const Eigen::Array4d edges = extents(points, camera, axes);
        const double unit = distance * camera.tangent;
        camera.target +=
            unit * (axes.col(0) * (edges[0] + edges[1]) + axes.col(1) * (edges[2] + edges[3])) / 2;
        distance *= std::max(edges[1] - edges[0], aspect * (edges[3] - edges[2])) / 2 / margin;
    }
    camera.position = camera.target - distance * axes.col(2);
    return camera;
}

}  // namespace bullet_buoyancy::recording
