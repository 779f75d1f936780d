#include "speed_vs_error/point_depths.h"

namespace bullet_buoyancy::demo {

PointDepths::PointDepths(const std::vector<Vec3>& points, const WaterField& water)
    : m_points(points.size(), 3),
      m_depths(points.size()),
      m_places(points.size(), 2),
      m_surface(points.size(), 3),
      m_water(water),
      m_isFlat(water.bounds().isFlat()) {
    for (std::size_t i = 0; i < points.size(); ++i)
        m_points.row(Eigen::Index(i)) = points[i].cast<float>().transpose().array();
}

const Eigen::ArrayXf& PointDepths::at(const FloatPose& pose, double time) {
    const Eigen::Vector3f up = pose.worldFromBody.row(2);
    m_depths =
        -pose.position.z() - up.x() * m_points.col(0) - up.y() * m_points.col(1) - up.z() * m_points.col(2);
    if (!m_isFlat) {
        sampleElevations(pose, time);
        m_depths += m_surface.col(0).cast<float>();
    }
    return m_depths;
}

void PointDepths::sampleElevations(const FloatPose& pose, double time) {
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector3f row = pose.worldFromBody.row(axis);
        m_places.col(axis) = (pose.position[axis] + row.x() * m_points.col(0) + row.y() * m_points.col(1) +
                              row.z() * m_points.col(2))
                                 .cast<double>();
    }
    m_water.sampleSurface(m_places, time, m_surface);
}

}  // namespace bullet_buoyancy::demo
