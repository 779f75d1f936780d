#include "bullet_buoyancy/hydrostatics/reference_water.h"

#include <cassert>
#include <cmath>

namespace bullet_buoyancy {

WaterAroundBody::WaterAroundBody(const Pose& pose, const WaterField& water, const HydrostaticQuery& query)
    : m_water(water),
      m_bounds(water.bounds()),
      m_model(query.pressure),
      m_time(query.time),
      m_frameFromBody(water.frame().worldFromFrame().transpose() * pose.worldFromBody()),
      m_comInFrame(water.frame().pointFromWorld(pose.position)) {
    assert(std::isfinite(m_bounds.slope) && std::isfinite(m_bounds.curvature));
}

double WaterAroundBody::steepness() const {
    return std::hypot(1.0, m_bounds.slope);
}

std::vector<double> WaterAroundBody::depths(const std::vector<Vec3>& pointsInBody) {
    const auto count = Eigen::Index(pointsInBody.size());
    Eigen::ArrayX2d places(count, 2);
    Eigen::ArrayX3d surface(count, 3);
    std::vector<double> depths(pointsInBody.size());
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec3 point = inFrame(pointsInBody[std::size_t(i)]);
        places.row(i) = point.head<2>().transpose().array();
        depths[std::size_t(i)] = -point.z();
    }
    m_water.sampleSurface(places, m_time, surface);
    m_samples += int(count);
    for (Eigen::Index i = 0; i < count; ++i)
        depths[std::size_t(i)] += surface(i, 0);
    return depths;
}

std::vector<double> WaterAroundBody::heads(const std::vector<Vec3>& pointsInBody,
                                           const std::vector<double>& depths) {
    if (m_model == PressureModel::hydrostatic) return depths;
    const auto count = Eigen::Index(pointsInBody.size());
    Eigen::ArrayX3d places(count, 3);
    Eigen::Array<double, Eigen::Dynamic, 10> expansions(count, 10);
    std::vector<double> heads(pointsInBody.size());
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec3 point = inFrame(pointsInBody[std::size_t(i)]);
        places.row(i) << point.x(), point.y(), -depths[std::size_t(i)];
        heads[std::size_t(i)] = -point.z();
    }
    m_water.expandWaveHead(places, m_time, expansions);
    m_samples += int(count);
    for (Eigen::Index i = 0; i < count; ++i)
        heads[std::size_t(i)] += expansions(i, 0);
    return heads;
}

Vec3 WaterAroundBody::surfaceGradientWorld(const Vec3& pointFromComWorld) {
    const Vec3 point = m_comInFrame + m_water.frame().vectorFromWorld(pointFromComWorld);
    const Eigen::ArrayX2d place = point.head<2>().transpose().array();
    Eigen::ArrayX3d surface(1, 3);
    m_water.sampleSurface(place, m_time, surface);
    ++m_samples;
    return m_water.frame().worldFromFrame() * Vec3(-surface(0, 1), -surface(0, 2), 1);
}

}  // namespace bullet_buoyancy
