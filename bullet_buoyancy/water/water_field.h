#pragma once

#include <limits>

#include "bullet_buoyancy/water/water_frame.h"

namespace bullet_buoyancy {

/// Upper bounds that hold everywhere and at all times; evaluators rely on them.
struct WaterBounds {
    double elevation = 0;  ///< largest height of the surface above or below the frame's z = 0, m
    double slope = 0;      ///< largest slope of the surface, m/m
    double curvature = 0;  ///< largest second derivative of the elevation along any horizontal direction, 1/m
    /// Largest third derivative of the elevation along any horizontal direction, 1/m^2; infinite where it is
    /// not known or the curvature jumps.
    double curvatureChange = std::numeric_limits<double>::infinity();
    /// How fast the largest third derivative grows with distance from a point at which it is told (see
    /// `expandSurface`), 1/m^3.
    double curvatureChangeGrowth = 0;
    bool still = true;  ///< no water moves: bodies at rest may sleep

    /// The surface is the still water level.
    bool isLevel() const { return elevation == 0; }
    /// The surface is a plane z = const, at any time.
    bool isFlat() const { return slope == 0 && curvature == 0; }
};

/// Batches, structure of arrays: one row a point, one contiguous column a coordinate, in the water's frame.
using HorizontalPoints = Eigen::Ref<const Eigen::ArrayX2d>;  ///< x, y in m
using SurfaceSamples = Eigen::Ref<Eigen::ArrayX3d>;  ///< elevation in m, its slopes along x and y in m/m
/// Elevation in m, slopes along x and y, second derivatives along xx, xy, yy in 1/m, and an upper bound of
/// the third derivative along any direction at the point, 1/m^2.
using SurfaceExpansions = Eigen::Ref<Eigen::Array<double, Eigen::Dynamic, 7>>;
/// Head in m, its first derivatives along x, y, s, its second ones along xx, xy, yy, xs, ys, ss in 1/m.
using HeadExpansions = Eigen::Ref<Eigen::Array<double, Eigen::Dynamic, 10>>;
using WaterPoints = Eigen::Ref<const Eigen::ArrayX3d>;  ///< x, y, z in m
using WaterVelocities = Eigen::Ref<Eigen::ArrayX3d>;    ///< velocity along x, y, z in m/s

/// Where the water's surface is and how the water moves, in the frame it was made with.
///
/// A field must outlive whatever uses it, must answer alike for the same arguments, and may be asked by
/// several threads at once. Implementations neither allocate nor throw.
class WaterField {
public:
    virtual ~WaterField() = default;

    /// In which points and results are given.
    const WaterFrame& frame() const { return m_frame; }

    /// kg/m^3
    double density() const { return m_density; }

    /// Asked for once a step and once an evaluation: cheap. They may change between steps (`HeightGrid`).
    virtual WaterBounds bounds() const = 0;

    /// Surface elevation and slopes at `points` at `time` (s). Both batches have the same number of rows.
    virtual void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const = 0;

    /// The same with second derivatives. Asked for only where `bounds().curvatureChange` is finite; a field
    /// that cannot tell need not override it.
    virtual void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const;

    /// Upper bound of the second derivative along any direction within `radius` (m) of a point (x, y in m),
    /// 1/m. Asked for only where `bounds().curvatureChange` is infinite.
    virtual double curvatureNear(const Vec2& point, double radius, double time) const;

    /// What the waves add to the head of water at rest (pressure over density and gravity) at points x, y and
    /// s, the height above the instantaneous surface (below zero under water; Wheeler 1970): the elevation at
    /// s = 0, less of it farther down. By default the elevation all the way down: hydrostatic pressure.
    virtual void expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const;

    /// Upper bound of the third derivative of the head along any direction in space, up to the height `above`
    /// (m) over the surface, 1/m^2.
    virtual double headCurvatureChange(double above) const;

    /// The same of this field's part of the head where its waves ride on others: heights are measured from a
    /// surface with the bounds `surface`.
    virtual double headCurvatureChangeUnder(const WaterBounds& surface, double above) const;

    /// Velocity of the water at `points` at `time` (s); above the surface, that of the water below it.
    virtual void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const = 0;

protected:
    /// `density` in kg/m^3, finite and above zero: asserted.
    WaterField(const WaterFrame& frame, double density);

    WaterField(const WaterField&) = default;             ///< for fields that are values
    WaterField& operator=(const WaterField&) = default;  ///< likewise

private:
    WaterFrame m_frame;
    double m_density;
};

}  // namespace bullet_buoyancy
