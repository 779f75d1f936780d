#include "bullet_buoyancy/water/water_patch.h"

#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

namespace {

/// Half of a box's diagonal, no less than in plan.
double halfDiagonal(const Vec3& edges, const Eigen::Array3i& counts) {
    return edges.cwiseQuotient(counts.matrix().cast<double>()).norm() / 2;
}

/// Divides the longest edges until the cells are small enough.
Eigen::Array3i countsFor(const Vec3& edges, double reach) {
    Eigen::Array3i counts = Eigen::Array3i::Ones();
    while (halfDiagonal(edges, counts) > reach) {
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

using CellHeads = Eigen::Array<double, Eigen::Dynamic, 10, Eigen::ColMajor, WaterPatch::mostCells, 10>;
using SurfaceRow = Eigen::Array<double, 1, 7>;
using HeadRow = Eigen::Array<double, 1, 10>;

Mat3 symmetric(double xx, double xy, double yy, double xz, double yz, double zz) {
    Mat3 m;
    m << xx, xy, xz,  //
        xy, yy, yz,   //
        xz, yz, zz;
    return m;
}

/// In the body's frame; z in the water's.
Quadratic depthOf(const SurfaceRow& surface, double z, const Mat3& bodyFromFrame) {
    const Vec3 x = bodyFromFrame.col(0), y = bodyFromFrame.col(1), up = bodyFromFrame.col(2);
    const Vec3 bendX = surface[3] * x + surface[4] * y, bendY = surface[4] * x + surface[5] * y;
    return {surface[0] - z, surface[1] * x + surface[2] * y - up,
            bendX * x.transpose() + bendY * y.transpose()};
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

double ExpansionError::reach(double error) const {
    if (!(second > 0 || third > 0 || fourth > 0)) return std::numeric_limits<double>::infinity();
    // From above, where each term alone would reach: Newton's method on a convex function stays above.
    double distance = std::numeric_limits<double>::infinity();
    if (second > 0) distance = std::min(distance, std::sqrt(error / second));
    if (third > 0) distance = std::min(distance, std::cbrt(error / third));
    if (fourth > 0) distance = std::min(distance, std::sqrt(std::sqrt(error / fourth)));
    for (int i = 0; i < 4; ++i) {
        const double slope = distance * (2 * second + distance * (3 * third + distance * 4 * fourth));
        distance -= (at(distance * distance) - error) / slope;
    }
    return distance;
}

/// Of -z + f(x, y, z - elevation), along a unit vector: f answers to a horizontal part of up to 1 and to a
/// change of z - elevation of up to 1 + slope, together up to sqrt(2) + slope.
double headBend(const WaterView& water) {
    const WaterBounds& bounds = water.bounds;
    if (water.pressure == PressureModel::hydrostatic) return bounds.curvature;
    const double steep = std::sqrt(2.0) + bounds.slope;
    return bounds.curvature * (steep * steep + bounds.slope);
}

/// Cells of the box, and where their centres are.
void WaterPatch::place(const BodyBox& box, double reach) {
    Vec3 edges = 2 * box.halfExtents;
    if (m_pressure == PressureModel::hydrostatic)
        edges = edges.cwiseProduct((Vec3::Ones() - m_up.cwiseAbs2()).cwiseMax(0).cwiseSqrt());
    m_counts = countsFor(edges, reach);
    m_lowest = box.centre - box.halfExtents;
    const Vec3 share = m_counts.cast<double>().inverse();
    m_cell = 2 * box.halfExtents.cwiseProduct(share);
    std::size_t i = 0;
    for (int z = 0; z < m_counts[2]; ++z)
        for (int y = 0; y < m_counts[1]; ++y)
            for (int x = 0; x < m_counts[0]; ++x)
                m_expansions[i++].centre = m_lowest + m_cell.cwiseProduct(Vec3(x + 0.5, y + 0.5, z + 0.5));
    // Edges are not square to each other in plan: no corner is farther than half of the diagonal in space, or
    // half of the edges' lengths in plan together.
    m_reach = std::min(m_cell.norm(), edges.dot(share)) / 2;
    // A triangle that is no larger than a cell, and has its middle in it, sticks out by two thirds of its
    // size.
    m_validity = cellCount() == 1 ? m_reach : 7.0 / 3 * m_reach;
}

/// By Taylor's theorem, with what the field tells of its derivatives near each cell, or anywhere.
void WaterPatch::setErrors(const WaterView& water, const CellPoints& points, const CellSurfaces& surfaces) {
    if (std::isfinite(water.bounds.curvatureChange) && m_pressure == PressureModel::waveDynamic)
        return setErrorsOfWaveHead(water, points, surfaces);
    const WaterBounds& bounds = water.bounds;
    ExpansionError anywhere{0, 0, 0};
    if (!std::isfinite(bounds.curvatureChange))
        anywhere.second = headBend(water) / 2;
    else
        anywhere.third = bounds.curvatureChange / 6;
    for (int i = 0; i < cellCount(); ++i) {
        WaterExpansion& cell = m_expansions[std::size_t(i)];
        cell.error = cell.errorFar = anywhere;
        if (m_pressure == PressureModel::waveDynamic) continue;
        if (anywhere.second > 0) {
            cell.error.second =
                water.field.curvatureNear({points(i, 0), points(i, 1)}, m_validity, water.time) / 2;
        } else {
            const ExpansionError near{0, surfaces(i, 6) / 6, bounds.curvatureChangeGrowth / 24};
            const double reach2 = m_reach * m_reach;
            if (near.at(reach2) < anywhere.at(reach2)) cell.error = near;
        }
    }
}

namespace {

/// How far the surface may rise over its chord between two points, m.
double sagOver(double distance, const WaterBounds& bounds) {
    return std::min(bounds.curvature * distance * distance / 8, 2 * bounds.elevation);
}

}  // namespace

/// Only wet points count: on the straight way to one from a cell's centre nothing is higher over the surface
/// than the centre, or than the surface itself, but for its bend.
void WaterPatch::setErrorsOfWaveHead(const WaterView& water, const CellPoints& points,
                                     const CellSurfaces& surfaces) {
    const WaterBounds& bounds = water.bounds;
    const double farthest = m_cell.cwiseProduct(m_counts.matrix().cast<double>()).norm();
    const double highest = (points.col(2) - surfaces.col(0)).maxCoeff();
    const double far =
        std::max(bounds.curvatureChange,
                 water.field.headCurvatureChange(std::max(0.0, highest) + sagOver(farthest, bounds)));
    for (int i = 0; i < cellCount(); ++i) {
        const double centre = points(i, 2) - surfaces(i, 0), top = centre + (1 + bounds.slope) * m_validity;
        const double sag = sagOver(m_validity, bounds);
        const double near = top < 0 ? water.field.headCurvatureChange(top)
                                    : std::max(bounds.curvatureChange,
                                               water.field.headCurvatureChange(std::max(0.0, centre) + sag));
        m_expansions[std::size_t(i)].error = {0, near / 6, 0};
        m_expansions[std::size_t(i)].errorFar = {0, far / 6, 0};
    }
}

/// Above the surface the head of short waves grows without limit, and nobody asks for it there: cells with
/// their centre so high that it does more harm than the longer way from the surface below are expanded there.
void WaterPatch::lowerDryCentres(const WaterView& water, const CellSurfaces& surfaces, CellPoints& points) {
    const double atSurface = water.field.headCurvatureChange(0);
    for (int i = 0; i < cellCount(); ++i) {
        const double height = points(i, 2) - surfaces(i, 0);
        if (!(height > 0)) continue;
        const double farther = (m_reach + height) / m_reach;
        if (water.field.headCurvatureChange(height) <= atSurface * farther * farther * farther) continue;
        points(i, 2) -= height;
        m_expansions[std::size_t(i)].centre -= height * m_up;
    }
}

WaterPatch::WaterPatch(const WaterView& water, const BodyBox& box, double reach)
    : m_up(water.upInBody()), m_pressure(water.pressure) {
    place(box, reach);
    const int count = cellCount();
    const Mat3 bodyFromFrame =
        water.pose.orientation.conjugate().toRotationMatrix() * water.field.frame().worldFromFrame();
    const Vec3 origin = water.field.frame().pointFromWorld(water.pose.position);
    CellPoints points(count, 3);
    for (int i = 0; i < count; ++i)
        points.row(i) =
            (origin + bodyFromFrame.transpose() * m_expansions[std::size_t(i)].centre).transpose().array();
    const bool knowsBend = std::isfinite(water.bounds.curvatureChange);
    CellSurfaces surfaces(count, 7);
    if (knowsBend)
        water.field.expandSurface(points.leftCols<2>(), water.time, surfaces);
    else {
        water.field.sampleSurface(points.leftCols<2>(), water.time, surfaces.leftCols<3>());
        surfaces.rightCols<4>().setZero();
    }
    if (knowsBend && m_pressure == PressureModel::waveDynamic) lowerDryCentres(water, surfaces, points);
    setErrors(water, points, surfaces);
    for (int i = 0; i < count; ++i) {
        WaterExpansion& cell = m_expansions[std::size_t(i)];
        cell.head = cell.depth = depthOf(surfaces.row(i), points(i, 2), bodyFromFrame);
    }
    if (m_pressure == PressureModel::hydrostatic) return;

    points.col(2) -= surfaces.col(0);
    CellHeads heads(count, 10);
    water.field.expandWaveHead(points, water.time, heads);
    for (int i = 0; i < count; ++i) {
        WaterExpansion& cell = m_expansions[std::size_t(i)];
        cell.head =
            turned(headOf(surfaces.row(i), heads.row(i), points(i, 2) + surfaces(i, 0)), bodyFromFrame);
        if (!knowsBend) cell.head.bend.setZero();
    }
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

}  // namespace bullet_buoyancy
