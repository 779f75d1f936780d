#pragma once

#include <limits>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"
#include "bullet_buoyancy/water/water_status.h"

namespace bullet_buoyancy {

/// A current that is `velocityWorld` at the surface and falls with the height z below it as
/// (1 + z / depth)^exponent, to nothing from `depth` on: DNV-RP-C205 (4.1.4) has an exponent of 1/7 for
/// tides, and of 1 for what the wind drives (50 m deep).
struct CurrentDef {
    Vec3 velocityWorld = Vec3::Zero();                       ///< at the surface, world axes, m/s
    double depth = std::numeric_limits<double>::infinity();  ///< down to which it runs, m; above zero
    double exponent = 0;                                     ///< 0: uniform; not negative
    double density = freshWaterDensity;                      ///< kg/m^3
};

/// Water with a flat surface in a current that may fall with depth. Summed with waves (`WaterSum`), the
/// profile hangs from their surface.
class Current final : public WaterField {
public:
    /// A refused current is flat water at rest: see `status`.
    Current(const WaterFrame& frame, const CurrentDef& def);

    /// Whether the current was accepted, and if not, why.
    const WaterStatus& status() const { return m_status; }

    WaterBounds bounds() const override;
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    WaterStatus m_status;
    Vec3 m_velocity = Vec3::Zero();  // in the water's frame
    double m_depth, m_exponent;
};

}  // namespace bullet_buoyancy
