#pragma once

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"
#include "bullet_buoyancy/water/wave_component.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// Which waves run, on deep water.
struct GerstnerWavesDef {
    std::vector<WaveComponent> components;  ///< steepness, the sum of amplitude * wavenumber: below 1
    double density = freshWaterDensity;     ///< kg/m^3
};

/// Trochoidal waves in deep water (Gerstner 1802; their sum: Tessendorf 2001): the surface's particle that
/// rests at a is, with theta = k . a - frequency * time + phase, at a - sum of amplitude * (k / |k|) *
/// sin(theta), at a height of the sum of amplitude * cos(theta). Crests are sharper than troughs.
///
/// One wave is an exact solution, with vorticity; a sum is a plausible surface. Its mean level lies
/// below z = 0, by half the sum of amplitude^2 * wavenumber. Pressure is taken as hydrostatic under the
/// instantaneous surface. Velocity is that of the particle at the place, whose orbit shrinks as
/// e^(wavenumber * b) with the height b at which it rests: exact for one wave.
class GerstnerWaves final : public WaterField {
public:
    /// Refused waves are flat water at rest: see `status`.
    GerstnerWaves(const WaterFrame& frame, const GerstnerWavesDef& def);

    /// Whether the waves were accepted, and if not, why.
    const WaterStatus& status() const { return m_status; }

    /// Sum of amplitude times wavenumber.
    double steepness() const { return m_steepness; }

    /// Height of the mean water level in the frame, m: not above zero.
    double meanLevel() const { return m_meanLevel; }

    WaterBounds bounds() const override { return m_bounds; }

    /// Heights are right to 1e-9 m, slopes to 1e-8, second derivatives to 1e-8 1/m.
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const override;

    /// Right to 1e-4 of the sum of amplitude * frequency.
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    WavesAtTime wavesAt(double time) const;
    void setReachOfVelocity(const std::vector<WaveComponent>& components);

    std::vector<WaveLanes> m_lanes;
    WaterStatus m_status;
    double m_steepness = 0;
    double m_meanLevel = 0;
    // How far a look at a particle tells, m: of the surface; of the velocity, from one under the surface; and
    // where to look for that, from one of the surface.
    double m_reach = 0, m_reachUnder = 0, m_reachFromTop = 0;
    double m_meanWavenumber = 0;  // 1/m
    WaterBounds m_bounds;
};

}  // namespace bullet_buoyancy
