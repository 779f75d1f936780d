#include "bullet_buoyancy/water/height_grid.h"

#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

namespace {

WaterStatus check(const HeightGridDef& def) {
    WaterStatus status;
    if (!std::isfinite(def.spacing) || !def.origin.allFinite()) status.error = WaterError::notFinite;
    if (def.nodesX < 2 || def.nodesY < 2 || def.spacing <= 0) status.error = WaterError::badGrid;
    return status;
}

/// Weights of the four nodes about a cell at the share t of it, and their derivatives by t.
void catmullRom(double t, Eigen::Vector4d& weights, Eigen::Vector4d& slopes) {
    const double t2 = t * t, t3 = t2 * t;
    weights << -t3 + 2 * t2 - t, 3 * t3 - 5 * t2 + 2, -3 * t3 + 4 * t2 + t, t3 - t2;
    slopes << -3 * t2 + 4 * t - 1, 9 * t2 - 10 * t, -9 * t2 + 8 * t + 1, 3 * t2 - 2 * t;
    weights /= 2;
    slopes /= 2;
}

/// From the four nodes to the control points of the same cubic in Bernstein's form: it lies within their
/// hull.
Eigen::Matrix4d bezierFromNodes() {
    Eigen::Matrix4d matrix;
    matrix << 0, 6, 0, 0,  //
        -1, 6, 1, 0,       //
        0, 1, 6, -1,       //
        0, 0, 6, 0;
    return matrix / 6;
}

template <typename Control>
double largest(const Eigen::MatrixBase<Control>& control) {
    return control.cwiseAbs().maxCoeff();
}

/// The largest values of the surface and its derivatives over one cell of unit size: those of a polynomial
/// are no larger than its control points. Returns the curvature.
double widen(WaterBounds& bounds, const Eigen::Matrix4d& control) {
    const Eigen::Matrix<double, 3, 4> alongX = 3 * (control.bottomRows<3>() - control.topRows<3>());
    const Eigen::Matrix<double, 4, 3> alongY = 3 * (control.rightCols<3>() - control.leftCols<3>());
    const double xx = largest(2 * (alongX.bottomRows<2>() - alongX.topRows<2>()));
    const double yy = largest(2 * (alongY.rightCols<2>() - alongY.leftCols<2>()));
    const double xy = largest(3 * (alongX.rightCols<3>() - alongX.leftCols<3>()));
    // The spectral norm of a matrix with these entries.
    const double curvature = (xx + yy) / 2 + std::hypot((xx - yy) / 2, xy);
    bounds.elevation = std::max(bounds.elevation, largest(control));
    bounds.slope = std::max(bounds.slope, std::hypot(largest(alongX), largest(alongY)));
    bounds.curvature = std::max(bounds.curvature, curvature);
    return curvature;
}

int wrapped(int index, int count) {
    return (index % count + count) % count;
}

}  // namespace

HeightGrid::HeightGrid(const WaterFrame& frame, const HeightGridDef& def)
    : WaterField(frame, def.density), m_def(def), m_status(check(def)) {
    if (!m_status.accepted()) {
        m_def = {};
        m_def.nodesX = m_def.nodesY = 2;
        m_def.moves = false;
    }
    m_heights.assign(std::size_t(m_def.nodesX) * std::size_t(m_def.nodesY), 0.0);
    m_rates = m_heights;
    measure();
}

template <typename Number>
WaterStatus HeightGrid::copy(const Number* heights, const Number* rates) {
    WaterStatus status = m_status;
    if (!status.accepted()) return status;
    const auto finite = [&](const Number* numbers) {
        return std::all_of(numbers, numbers + m_heights.size(),
                           [](Number number) { return std::isfinite(number); });
    };
    if (!finite(heights) || (rates && !finite(rates))) {
        status.error = WaterError::notFinite;
        return status;
    }
    std::copy(heights, heights + m_heights.size(), m_heights.begin());
    if (rates)
        std::copy(rates, rates + m_rates.size(), m_rates.begin());
    else
        std::fill(m_rates.begin(), m_rates.end(), 0.0);
    measure();
    return status;
}

WaterStatus HeightGrid::setHeights(const double* heights, const double* rates) {
    return copy(heights, rates);
}

WaterStatus HeightGrid::setHeights(const float* heights, const float* rates) {
    return copy(heights, rates);
}

/// The sixteen values about a cell, one row a node along x.
Eigen::Matrix4d HeightGrid::patch(const std::vector<double>& values, int cellX, int cellY) const {
    Eigen::Matrix4d nodes;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            int x = cellX + i - 1, y = cellY + j - 1;
            x = m_def.periodic ? wrapped(x, m_def.nodesX) : std::clamp(x, 0, m_def.nodesX - 1);
            y = m_def.periodic ? wrapped(y, m_def.nodesY) : std::clamp(y, 0, m_def.nodesY - 1);
            nodes(i, j) = values[std::size_t(x) + std::size_t(y) * std::size_t(m_def.nodesX)];
        }
    return nodes;
}

/// Over the cells beyond the edges too, in which the surface becomes level.
void HeightGrid::measure() {
    static const Eigen::Matrix4d toBezier = bezierFromNodes();
    m_bounds = {};
    m_curvatures.clear();
    const double perSquare = 1 / (m_def.spacing * m_def.spacing);
    for (int y = firstCell(); y < m_def.nodesY; ++y)
        for (int x = firstCell(); x < m_def.nodesX; ++x) {
            const double curvature =
                widen(m_bounds, toBezier * patch(m_heights, x, y) * toBezier.transpose());
            m_curvatures.push_back(curvature * perSquare);
        }
    m_bounds.slope /= m_def.spacing;
    m_bounds.curvature *= perSquare;
    if (m_bounds.isFlat()) m_bounds.curvatureChange = 0;
    m_bounds.still = !m_def.moves;
}

/// Of the cells that the circle's square touches.
double HeightGrid::curvatureNear(const Vec2& point, double radius, double) const {
    const int perRow = m_def.nodesX - firstCell();
    const auto cellAt = [&](double place) { return int(std::floor(std::clamp(place, -1e6, 1e6))); };
    const Vec2 low = (point - Vec2::Constant(radius) - m_def.origin) / m_def.spacing,
               high = (point + Vec2::Constant(radius) - m_def.origin) / m_def.spacing;
    const int lastX = cellAt(high.x()), lastY = cellAt(high.y());
    constexpr int mostCells = 6;  // along either direction
    if (lastX - cellAt(low.x()) >= mostCells || lastY - cellAt(low.y()) >= mostCells)
        return m_bounds.curvature;
    double curvature = 0;
    for (int y = cellAt(low.y()); y <= lastY; ++y)
        for (int x = cellAt(low.x()); x <= lastX; ++x) {
            const int i = m_def.periodic ? wrapped(x, m_def.nodesX) : std::clamp(x + 1, 0, perRow - 1);
            const int j = m_def.periodic ? wrapped(y, m_def.nodesY) : std::clamp(y + 1, 0, m_def.nodesY);
            curvature =
                std::max(curvature, m_curvatures[std::size_t(i) + std::size_t(j) * std::size_t(perRow)]);
        }
    return curvature;
}

/// Value and derivatives along x and y.
Eigen::Array3d HeightGrid::interpolate(const std::vector<double>& values, double x, double y) const {
    const auto cell = [&](double place, int count) {
        if (m_def.periodic) place -= count * std::floor(place / count);
        // Level from here on. What is not a number goes to the upper end.
        return std::max(-3.0, std::min(count + 2.0, place));
    };
    const double placeX = cell((x - m_def.origin.x()) / m_def.spacing, m_def.nodesX);
    const double placeY = cell((y - m_def.origin.y()) / m_def.spacing, m_def.nodesY);
    const double cellX = std::floor(placeX), cellY = std::floor(placeY);
    Eigen::Vector4d weightsX, slopesX, weightsY, slopesY;
    catmullRom(placeX - cellX, weightsX, slopesX);
    catmullRom(placeY - cellY, weightsY, slopesY);
    const Eigen::Matrix4d nodes = patch(values, int(cellX), int(cellY));
    const Eigen::Vector4d alongX = nodes * weightsY;
    return {weightsX.dot(alongX), slopesX.dot(alongX) / m_def.spacing,
            weightsX.dot(nodes * slopesY) / m_def.spacing};
}

void HeightGrid::sampleSurface(HorizontalPoints points, double, SurfaceSamples samples) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row)
        samples.row(row) = interpolate(m_heights, points(row, 0), points(row, 1)).transpose();
}

void HeightGrid::sampleVelocity(WaterPoints points, double, WaterVelocities velocities) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row)
        velocities.row(row) << 0, 0, interpolate(m_rates, points(row, 0), points(row, 1))[0];
}

}  // namespace bullet_buoyancy
