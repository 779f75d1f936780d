#pragma once

#include <functional>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// The functions, and what holds of them.
struct FunctionWaterDef {
    /// Elevation (m) and its slopes along x and y at x, y (m) and time (s), in the water's frame; not null.
    std::function<Eigen::Array3d(double x, double y, double time)> surface;
    /// Velocity (m/s) at a point (m) and time (s), in the water's frame; null: at rest.
    std::function<Vec3(const Vec3& point, double time)> velocity;
    WaterBounds bounds;  ///< what the user knows of the surface; its third derivative is not used
    double density = freshWaterDensity;  ///< kg/m^3
};

/// Water that the user's functions describe. They are bound by the promises of `WaterField`: they answer
/// alike for the same arguments, to several threads at once, and keep within the bounds. Pressure is
/// hydrostatic.
class FunctionWater final : public WaterField {
public:
    /// `def.surface` must not be null: asserted.
    FunctionWater(const WaterFrame& frame, const FunctionWaterDef& def);

    WaterBounds bounds() const override { return m_def.bounds; }
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    FunctionWaterDef m_def;
};

}  // namespace bullet_buoyancy
