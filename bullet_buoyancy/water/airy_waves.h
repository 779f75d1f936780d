#pragma once

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/dispersion.h"
#include "bullet_buoyancy/water/water_field.h"
#include "bullet_buoyancy/water/wave_component.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// Which waves run on what water.
struct AiryWavesDef {
    std::vector<WaveComponent> components;                   ///< of any number and directions
    double depth = std::numeric_limits<double>::infinity();  ///< of the still water, m; above zero
    double density = freshWaterDensity;                      ///< kg/m^3
};

/// Linear waves (Airy 1845), the sum of their components.
///
/// Pressure and velocity fall with depth as cosh k(depth + s) / cosh(k depth), in deep water as e^(k s), with
/// s the height above the instantaneous surface (stretching of Wheeler 1970, not scaled with depth: the bed
/// rises and falls with the surface). Above the surface the head goes on by the same formula and the velocity
/// is that of the surface; below the bed the velocity is that of the bed.
class AiryWaves final : public WaterField {
public:
    /// Refused waves are flat water at rest: see `status`.
    AiryWaves(const WaterFrame& frame, const AiryWavesDef& def);

    /// Whether the waves were accepted, and if not, why.
    const WaterStatus& status() const { return m_status; }

    WaterBounds bounds() const override { return m_bounds; }
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const override;
    void expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const override;

    /// Holds wherever there is water: from the bed on up.
    double headCurvatureChangeUnder(const WaterBounds& surface, double above) const override;
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    WavesAtTime wavesAt(double time) const;

    std::vector<WaveComponent> m_components;
    std::vector<WaveLanes> m_lanes;
    double m_depth;
    WaterStatus m_status;
    WaterBounds m_bounds;
};

}  // namespace bullet_buoyancy
