#pragma once

#include "bullet_buoyancy/water/water_frame.h"

namespace bullet_buoyancy {

/// Upper bounds that hold everywhere and at all times; evaluators rely on them.
struct WaterBounds {
    double elevation = 0;  ///< largest height of the surface above or below the frame's z = 0, m
    double slope = 0;      ///< largest slope of the surface, m/m
    double curvature = 0;  ///< largest second derivative of the elevation along any horizontal direction, 1/m
    bool still = true;     ///< no water moves: bodies at rest may sleep
};

/// Batches, structure of arrays: one row a point, one contiguous column a coordinate, in the water's frame.
using HorizontalPoints = Eigen::Ref<const Eigen::ArrayX2d>;  ///< x, y in m
using SurfaceSamples = Eigen::Ref<Eigen::ArrayX3d>;     ///< elevation in m, its slopes along x and y in m/m
using WaterPoints = Eigen::Ref<const Eigen::ArrayX3d>;  ///< x, y, z in m
using WaterVelocities = Eigen::Ref<Eigen::ArrayX3d>;    ///< velocity along x, y, z in m/s

/// Where the water's surface is and how the water moves, in the frame it was made with.
///
/// A field must outlive whatever uses it, must answer alike for the same arguments, and may be asked by
/// several threads at once. Implementations neither allocate nor throw.
class WaterField {
public:
    virtual ~WaterField() = default;

    const WaterFrame& frame() const { return m_frame; }

    /// kg/m^3
    double density() const { return m_density; }

    virtual WaterBounds bounds() const = 0;

    /// Surface elevation and slopes at `points` at `time` (s). Both batches have the same number of rows.
    virtual void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const = 0;

    /// Velocity of the water at `points` at `time` (s); above the surface, that of the water below it.
    virtual void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const = 0;

protected:
    /// `density` in kg/m^3, finite and above zero: asserted.
    WaterField(const WaterFrame& frame, double density);

    WaterField(const WaterField&) = default;
    WaterField& operator=(const WaterField&) = default;

private:
    WaterFrame m_frame;
    double m_density;
};

}  // namespace bullet_buoyancy
