#pragma once

#include <array>

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

/// The water about a point, in the frame of a body.
struct WaterExpansion {
    Vec3 centre;      ///< in the body's frame, m
    Quadratic depth;  ///< below the surface, measured vertically, m
    Quadratic head;   ///< pressure over density and gravity, m: the depth, or less where waves decay

    double depthAt(const Vec3& pointInBody) const { return depth.at(pointInBody - centre); }
    double headAt(const Vec3& pointInBody) const { return head.at(pointInBody - centre); }
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

/// How far an expansion strays from the true depth and head: by no more than coefficient distance^power.
struct ExpansionError {
    double coefficient;
    int power;        ///< 3 where the water tells its second derivatives, 2 where it does not
    bool horizontal;  ///< the distance is that in plan

    double at(double distanceSquared) const;

    /// The largest distance with no more than `error` (m).
    double reach(double error) const;
};

/// For a hull no point of which is farther than `above` (m) over the surface.
ExpansionError expansionError(const WaterView& water, double above);

/// The water about a hull as expansions about the centres of cells of its box: one batch of samples, as many
/// as the waves' shortness asks for, however fine the hull's mesh.
class WaterPatch {
public:
    static constexpr int mostCells = 256;

    /// Cells that reach about `reach` (m) from their centres, or as many as there may be.
    WaterPatch(const WaterView& water, const BodyBox& box, const ExpansionError& error, double reach);

    /// That of the cell which holds the point, or is next to it.
    const WaterExpansion& near(const Vec3& pointInBody) const;

    /// Upper bound of the error of an expansion at a point, m.
    double errorAt(const WaterExpansion& expansion, const Vec3& pointInBody) const;

    /// The same within a distance (m) from its centre.
    double errorWithin(const WaterExpansion&, double distance) const {
        return m_error.at(distance * distance);
    }

    const Vec3& upInBody() const { return m_up; }
    PressureModel pressure() const { return m_pressure; }
    int cellCount() const { return m_counts.prod(); }

    /// Edges of a cell along the body's axes, m.
    const Vec3& cell() const { return m_cell; }

private:
    Vec3 m_up;
    PressureModel m_pressure;
    ExpansionError m_error;
    Vec3 m_lowest, m_cell;  // corner of the box, edges of a cell
    Eigen::Array3i m_counts;
    std::array<WaterExpansion, mostCells> m_expansions;
};

}  // namespace bullet_buoyancy
