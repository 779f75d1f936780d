#pragma once

#include <vector>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// Several fields in one: swell and wind sea and current. Elevations, heads and velocities add up; each
/// field's depths are measured from the common surface.
class WaterSum final : public WaterField {
public:
    /// At least one field, none null, all of the same frame: asserted. They must outlive the sum. `density`
    /// in kg/m^3; theirs are not used.
    explicit WaterSum(const std::vector<const WaterField*>& fields, double density = freshWaterDensity);

    WaterBounds bounds() const override;
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const override;
    double curvatureNear(const Vec2& point, double radius, double time) const override;
    void expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const override;
    double headCurvatureChangeUnder(const WaterBounds& surface, double above) const override;
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    std::vector<const WaterField*> m_fields;
};

}  // namespace bullet_buoyancy
