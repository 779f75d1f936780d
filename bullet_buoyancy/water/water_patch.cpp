#include "bullet_buoyancy/water/water_patch.h"

#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

namespace {

/// Half of a cell's diagonal, in space or in plan, from the length of each of its edges there.
double reachOf(const Vec3& edges, const Eigen::Array3i& counts) {
    return edges.cwiseQuotient(counts.matrix().cast<double>()).norm() / 2;
}

/// Divides the longest edges until the cells are small enough.
Eigen::Array3i countsFor(const Vec3& edges, double reach) {
    Eigen::Array3i counts = Eigen::Array3i::Ones();
    while (reachOf(edges, counts) > reach) {
        Eigen::Index longest = 0;
        edges.cwiseQuotient(counts.matrix().cast<double>()).maxCoeff(&longest);
        ++counts[longest];
        if (counts.prod() > WaterPatch::mostCells) {
            --counts[longest];
            break;
        }
    }
    return counts;
}

using SurfaceRow = Eigen::Array<double, 1, 6>;
using HeadRow = Eigen::Array<double, 1, 10>;

Mat3 symmetric(double xx, double xy, double yy, double xz, double yz, double zz) {
    Mat3 m;
    m << xx, xy, xz,  //
        xy, yy, yz,   //
        xz, yz, zz;
    return m;
}

/// In the water's frame.
Quadratic depthOf(const SurfaceRow& surface, double z) {
    return {surface[0] - z, Vec3(surface[1], surface[2], -1),
            symmetric(surface[3], surface[4], surface[5], 0, 0, 0)};
}

/// -z + f(x, y, z - elevation) by the chain rule, in the water's frame.
Quadratic headOf(const SurfaceRow& surface, const HeadRow& f, double z) {
    const double ex = surface[1], ey = surface[2], fs = f[3], fxs = f[7], fys = f[8], fss = f[9];
    return {f[0] - z, Vec3(f[1] - fs * ex, f[2] - fs * ey, fs - 1),
            symmetric(f[4] - 2 * fxs * ex + fss * ex * ex - fs * surface[3],
                      f[5] - fxs * ey - fys * ex + fss * ex * ey - fs * surface[4],
                      f[6] - 2 * fys * ey + fss * ey * ey - fs * surface[5], fxs - fss * ex, fys - fss * ey,
                      fss)};
}

Quadratic turned(const Quadratic& q, const Mat3& bodyFromFrame) {
    return {q.value, bodyFromFrame * q.gradient, bodyFromFrame * q.bend * bodyFromFrame.transpose()};
}

}  // namespace

double ExpansionError::at(double distanceSquared) const {
    return coefficient * (power == 2 ? distanceSquared : distanceSquared * std::sqrt(distanceSquared));
}

double ExpansionError::reach(double error) const {
    if (!(coefficient > 0)) return std::numeric_limits<double>::infinity();
    return power == 2 ? std::sqrt(error / coefficient) : std::cbrt(error / coefficient);
}

/// Of -z + f(x, y, z - elevation), along a unit vector: f answers to a horizontal part of up to 1 and to a
/// change of z - elevation of up to 1 + slope, together up to sqrt(2) + slope.
double headBend(const WaterView& water) {
    const WaterBounds& bounds = water.bounds;
    if (water.pressure == PressureModel::hydrostatic) return bounds.curvature;
    const double steep = std::sqrt(2.0) + bounds.slope;
    return bounds.curvature * (steep * steep + bounds.slope);
}

ExpansionError expansionError(const WaterView& water, double above) {
    const bool hydrostatic = water.pressure == PressureModel::hydrostatic;
    double change = water.bounds.curvatureChange;
    if (!hydrostatic) change = std::max(change, water.field.headCurvatureChange(above));
    if (std::isfinite(change)) return {change / 6, 3, hydrostatic};
    return {headBend(water) / 2, 2, hydrostatic};
}

namespace {

using Points = Eigen::Array<double, Eigen::Dynamic, 3, Eigen::ColMajor, WaterPatch::mostCells, 3>;
using Surfaces = Eigen::Array<double, Eigen::Dynamic, 6, Eigen::ColMajor, WaterPatch::mostCells, 6>;
using Heads = Eigen::Array<double, Eigen::Dynamic, 10, Eigen::ColMajor, WaterPatch::mostCells, 10>;

}  // namespace

WaterPatch::WaterPatch(const WaterView& water, const BodyBox& box, const ExpansionError& error, double reach)
    : m_up(water.upInBody()), m_pressure(water.pressure), m_error(error) {
    const Mat3 bodyFromFrame =
        water.pose.orientation.conjugate().toRotationMatrix() * water.field.frame().worldFromFrame();
    Vec3 edges = 2 * box.halfExtents;
    if (error.horizontal)
        edges = edges.cwiseProduct((Vec3::Ones() - m_up.cwiseAbs2()).cwiseMax(0).cwiseSqrt());
    m_counts = countsFor(edges, reach);
    m_lowest = box.centre - box.halfExtents;
    m_cell = 2 * box.halfExtents.cwiseQuotient(m_counts.matrix().cast<double>());

    const int count = cellCount();
    const Vec3 origin = water.field.frame().pointFromWorld(water.pose.position);
    Points points(count, 3);
    for (int i = 0; i < count; ++i) {
        const Eigen::Array3d index(i % m_counts[0], i / m_counts[0] % m_counts[1],
                                   i / (m_counts[0] * m_counts[1]));
        m_expansions[std::size_t(i)].centre = m_lowest + m_cell.cwiseProduct((index + 0.5).matrix());
        points.row(i) =
            (origin + bodyFromFrame.transpose() * m_expansions[std::size_t(i)].centre).transpose().array();
    }
    Surfaces surfaces(count, 6);
    if (error.power == 3)
        water.field.expandSurface(points.leftCols<2>(), water.time, surfaces);
    else {
        water.field.sampleSurface(points.leftCols<2>(), water.time, surfaces.leftCols<3>());
        surfaces.rightCols<3>().setZero();
    }
    for (int i = 0; i < count; ++i) {
        WaterExpansion& expansion = m_expansions[std::size_t(i)];
        expansion.depth = turned(depthOf(surfaces.row(i), points(i, 2)), bodyFromFrame);
        expansion.head = expansion.depth;
    }
    if (m_pressure == PressureModel::hydrostatic) return;

    Points below = points;
    below.col(2) -= surfaces.col(0);
    Heads heads(count, 10);
    water.field.expandWaveHead(below, water.time, heads);
    if (error.power == 2) heads.rightCols<6>().setZero();
    for (int i = 0; i < count; ++i)
        m_expansions[std::size_t(i)].head =
            turned(headOf(surfaces.row(i), heads.row(i), points(i, 2)), bodyFromFrame);
    if (error.power == 2)
        for (int i = 0; i < count; ++i)
            m_expansions[std::size_t(i)].head.bend.setZero();
}

const WaterExpansion& WaterPatch::near(const Vec3& pointInBody) const {
    if (cellCount() == 1) return m_expansions[0];
    const auto indexAlong = [&](int axis) {
        const double cells = (pointInBody[axis] - m_lowest[axis]) / m_cell[axis];
        return cells > 0 ? std::min(int(cells), m_counts[axis] - 1) : 0;
    };
    return m_expansions[std::size_t(indexAlong(0) +
                                    m_counts[0] * (indexAlong(1) + m_counts[1] * indexAlong(2)))];
}

double WaterPatch::errorAt(const WaterExpansion& expansion, const Vec3& pointInBody) const {
    const Vec3 offset = pointInBody - expansion.centre;
    const double along = m_error.horizontal ? m_up.dot(offset) : 0;
    return m_error.at(std::max(0.0, offset.squaredNorm() - along * along));
}

}  // namespace bullet_buoyancy
