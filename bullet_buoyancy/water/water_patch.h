#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/water/pressure_model.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// A function of position, to second order.
struct Quadratic {
    double value;
    Vec3 gradient;
    Mat3 bend;  ///< second derivatives

    double at(const Vec3& offset) const { return value + offset.dot(gradient + bend * offset / 2); }
};

/// Water with waves, seen from a body.
struct WaterView {
    const WaterField& field;
    WaterBounds bounds;
    Pose pose;
    double time;  ///< s
    PressureModel pressure;

    Vec3 upInBody() const { return pose.orientation.conjugate() * field.frame().upWorld(); }
};

/// Upper bound of the second derivative of depth and head along any direction, 1/m.
double headBend(const WaterView& water);

/// The box about a hull, along the body's axes.
struct BodyBox {
    Vec3 centre, halfExtents;  ///< m
};

/// How far an expansion may stray from the true depth and head, m, at a distance from its centre: a
/// polynomial without its first terms.
struct ExpansionError {
    double second, third, fourth;  ///< coefficients of the distance's powers

    double at(double distanceSquared) const {
        const double fromThird = third > 0 || fourth > 0 ? distanceSquared * std::sqrt(distanceSquared) : 0;
        return distanceSquared * (second + fourth * distanceSquared) + third * fromThird;
    }

    /// The largest distance with no more than `error` (m).
    double reach(double error) const;
};

/// The water about a point, in the frame of a body.
struct WaterExpansion {
    Vec3 centre;              ///< in the body's frame, m
    Quadratic depth;          ///< below the surface, measured vertically, m
    Quadratic head;           ///< pressure over density and gravity, m: the depth, or less where waves decay
    ExpansionError error;     ///< for triangles no larger than the cell with their middle in it
    ExpansionError errorFar;  ///< anywhere

    double depthAt(const Vec3& pointInBody) const { return depth.at(pointInBody - centre); }
    double headAt(const Vec3& pointInBody) const { return head.at(pointInBody - centre); }
};

/// The water about a hull as expansions about the centres of cells of its box: one batch of samples, as many
/// as the waves' shortness asks for, however fine the hull's mesh. Where pressure decays and waves are short,
/// cells in the air are expanded about the surface below their centre.
class WaterPatch {
public:
    static constexpr int mostCells = 256;
    using CellPoints = Eigen::Array<double, Eigen::Dynamic, 3, Eigen::ColMajor, mostCells, 3>;
    using CellSurfaces = Eigen::Array<double, Eigen::Dynamic, 7, Eigen::ColMajor, mostCells, 7>;

    /// Cells that reach about `reach` (m) from their centres, or as many as there may be.
    WaterPatch(const WaterView& water, const BodyBox& box, double reach);

    /// That of the cell which holds the point, or is next to it.
    const WaterExpansion& near(const Vec3& pointInBody) const;

    /// Squares of the distances that count from an expansion's centre: in plan where pressure is hydrostatic,
    /// m^2.
    double distanceSquared(const WaterExpansion& expansion, const Vec3& pointInBody) const {
        const Vec3 offset = pointInBody - expansion.centre;
        const double along = m_pressure == PressureModel::hydrostatic ? m_up.dot(offset) : 0;
        return std::max(0.0, offset.squaredNorm() - along * along);
    }

    /// The error of an expansion up to a distance from its centre.
    const ExpansionError& errorOf(const WaterExpansion& expansion, double distanceSquared) const {
        return distanceSquared <= m_validity * m_validity ? expansion.error : expansion.errorFar;
    }

    /// Upper bound of the error of an expansion at a point, m.
    double errorAt(const WaterExpansion& expansion, const Vec3& pointInBody) const {
        const double distance2 = distanceSquared(expansion, pointInBody);
        return errorOf(expansion, distance2).at(distance2);
    }

    /// The same within a distance (m) from its centre.
    double errorWithin(const WaterExpansion& expansion, double distance) const {
        return errorOf(expansion, distance * distance).at(distance * distance);
    }

    const Vec3& upInBody() const { return m_up; }
    PressureModel pressure() const { return m_pressure; }
    int cellCount() const { return m_counts.prod(); }

    /// From the centre of a cell to its farthest point, as distances count, m. No bound for cells in the air.
    double reach() const { return m_reach; }

    /// How far from their centres the cells' own errors hold, as distances count, m.
    double validity() const { return m_validity; }

    /// Edges of a cell along the body's axes, m.
    const Vec3& cell() const { return m_cell; }

private:
    void place(const BodyBox& box, double reach);
    void lowerDryCentres(const WaterView& water, const CellSurfaces& surfaces, CellPoints& points);
    void setErrors(const WaterView& water, const CellPoints& points, const CellSurfaces& surfaces);
    void setErrorsOfWaveHead(const WaterView& water, const CellPoints& points, const CellSurfaces& surfaces);

    Vec3 m_up;
    PressureModel m_pressure;
    double m_reach;         // of a cell, in space or in plan
    double m_validity;      // of the cells' own errors from their centres, m
    Vec3 m_lowest, m_cell;  // corner of the box, edges of a cell
    Eigen::Array3i m_counts;
    std::array<WaterExpansion, mostCells> m_expansions;
};

}  // namespace bullet_buoyancy
