#pragma once

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// What flat water is like; still fresh water by default.
struct FlatWaterDef {
    double density = freshWaterDensity;     ///< kg/m^3
    Vec3 flowVelocityWorld = Vec3::Zero();  ///< uniform current, world axes, m/s
};

/// Water whose surface is the plane z = 0 of its frame, at rest or in a uniform current.
class FlatWater final : public WaterField {
public:
    /// Density as of `WaterField`; the current must be finite: asserted.
    explicit FlatWater(const WaterFrame& frame, const FlatWaterDef& def = {});

    WaterBounds bounds() const override;
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    Vec3 m_flowVelocity;  // in the water's frame
};

}  // namespace bullet_buoyancy
