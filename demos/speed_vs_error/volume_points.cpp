#include "speed_vs_error/volume_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/random_numbers.h"
#include "scenes/study_hulls.h"
#include "speed_vs_error/point_depths.h"
#include "speed_vs_error/points_inside.h"

namespace bullet_buoyancy::demo {

namespace {

using Eigen::Vector3f;

constexpr int finePointsAlong = 32;

/// The points nearest to each of the centres: a point for each centre that has any.
std::vector<VolumePoint> gather(const std::vector<Vec3>& fine, const std::vector<std::size_t>& owner,
                                std::size_t owners, double volume) {
    std::vector<VolumePoint> points(owners, {Vec3::Zero(), 0});
    const double share = volume / double(fine.size());
    for (std::size_t i = 0; i < fine.size(); ++i) {
        points[owner[i]].position += share * fine[i];
        points[owner[i]].volume += share;
    }
    points.erase(
        std::remove_if(points.begin(), points.end(), [](const VolumePoint& p) { return p.volume == 0; }),
        points.end());
    for (VolumePoint& point : points)
        point.position /= point.volume;
    return points;
}

std::size_t nearestTo(const Vec3& place, const std::vector<VolumePoint>& points) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if ((points[i].position - place).squaredNorm() < (points[nearest].position - place).squaredNorm())
            nearest = i;
    return nearest;
}

class PointBuoyancy final : public ReadyEvaluator {
public:
    PointBuoyancy(const VolumePoints& points, const WaterField& water)
        : m_depths(positionsOf(points), water),
          m_cell(points.cell.cast<float>()),
          m_density(float(water.density())) {
        for (const VolumePoint& point : points.points)
            m_points.push_back({point.position.cast<float>(), float(point.volume)});
    }

    Wrench evaluate(const Pose& pose, const HydrostaticQuery& query) override {
        const FloatPose at(pose);
        // As wide as the cell's extent along the vertical is in the root of the mean square: the height of an
        // upright cell.
        const float perHeight = 1 / m_cell.cwiseProduct(at.worldFromBody.row(2).transpose()).norm();
        const Eigen::ArrayXf& depths = m_depths.at(at, query.time);
        float volume = 0;
        Vector3f moment = Vector3f::Zero();
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            const float fill = std::clamp(0.5f + depths[Eigen::Index(i)] * perHeight, 0.0f, 1.0f);
            const float wet = fill * m_points[i].volume;
            volume += wet;
            moment += wet * m_points[i].position;
        }
        const float weight = m_density * float(query.gravity);
        const Vector3f arm = at.worldFromBody * moment;
        return {{0, 0, weight * volume},
                {weight * arm.y(), -weight * arm.x(), 0},
                std::numeric_limits<double>::infinity()};
    }

private:
    struct Point {
        Vector3f position;
        float volume;
    };

    static std::vector<Vec3> positionsOf(const VolumePoints& points) {
        std::vector<Vec3> positions;
        for (const VolumePoint& point : points.points)
            positions.push_back(point.position);
        return positions;
    }

    PointDepths m_depths;
    std::vector<Point> m_points;
    Vector3f m_cell;
    float m_density;
};

}  // namespace

VolumePoints pontoonsOf(const Hull& hull, int count) {
    constexpr int rounds = 30;
    const std::vector<Vec3> fine = pointsInside(scenes::asMesh(hull), finePointsAlong);
    scenes::RandomNumbers random(1);
    std::vector<VolumePoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back({fine[std::size_t(random.index(int(fine.size())))], 0});
    std::vector<std::size_t> owner(fine.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < fine.size(); ++i)
            owner[i] = nearestTo(fine[i], points);
        points = gather(fine, owner, points.size(), hull.moments.volume);
    }
    return {points, Vec3::Constant(std::cbrt(hull.moments.volume / count))};
}

VolumePoints voxelsOf(const Hull& hull, int cellsAlong) {
    const std::vector<Vec3> fine = pointsInside(scenes::asMesh(hull), finePointsAlong);
    const Vec3 cell = 2 * hull.halfExtents / cellsAlong;
    const Vec3 corner = hull.bounds.centre - hull.halfExtents;
    std::vector<std::size_t> owner;
    for (const Vec3& point : fine) {
        std::size_t index = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const int along = int((point[axis] - corner[axis]) / cell[axis]);
            index = index * std::size_t(cellsAlong) + std::size_t(std::clamp(along, 0, cellsAlong - 1));
        }
        owner.push_back(index);
    }
    const auto cells = std::size_t(cellsAlong * cellsAlong * cellsAlong);
    return {gather(fine, owner, cells, hull.moments.volume), cell};
}

std::unique_ptr<ReadyEvaluator> pressPoints(const VolumePoints& points, const WaterField& water) {
    return std::make_unique<PointBuoyancy>(points, water);
}

}  // namespace bullet_buoyancy::demo
