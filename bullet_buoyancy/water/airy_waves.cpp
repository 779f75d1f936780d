#include "bullet_buoyancy/water/airy_waves.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/water/pack_waves.h"
#include "bullet_buoyancy/water/third_derivative.h"
#include "bullet_buoyancy/water/wave_kernels.h"

namespace bullet_buoyancy {

namespace {

WaterStatus check(const AiryWavesDef& def) {
    WaterStatus status = checkComponents(def.components);
    if (!(def.depth > 0)) status.error = WaterError::badDepth;
    return status;
}

WaterBounds boundsOf(const std::vector<WaveComponent>& components) {
    WaterBounds bounds;
    bounds.elevation = waveMoment(components, 0);
    bounds.slope = waveMoment(components, 1);
    bounds.curvature = waveMoment(components, 2);
    bounds.curvatureChange = waveMoment(components, 3);
    bounds.curvatureChangeGrowth = waveMoment(components, 4);
    bounds.still = bounds.elevation == 0;
    return bounds;
}

}  // namespace

AiryWaves::AiryWaves(const WaterFrame& frame, const AiryWavesDef& def)
    : WaterField(frame, def.density), m_depth(def.depth), m_status(check(def)) {
    if (m_status.accepted()) m_components = def.components;
    m_lanes = packWaves(m_components, m_depth);
    m_bounds = boundsOf(m_components);
}

WavesAtTime AiryWaves::wavesAt(double time) const {
    return {m_lanes.data(), int(m_lanes.size()), time, m_depth};
}

void AiryWaves::sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const {
    const WavesAtTime waves = wavesAt(time);
    const auto sumSurface = waveKernels().surface;
    double sums[3];
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        sumSurface(waves, points(row, 0), points(row, 1), sums);
        samples.row(row) = Eigen::Map<const Eigen::Array<double, 1, 3>>(sums);
    }
}

void AiryWaves::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    const WavesAtTime waves = wavesAt(time);
    const auto sumSurface = waveKernels().bentSurface;
    double sums[10];
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        sumSurface(waves, points(row, 0), points(row, 1), sums);
        expansions.row(row) << Eigen::Map<const Eigen::Array<double, 1, 6>>(sums),
            largestThirdDerivative(sums[6], sums[7], sums[8], sums[9]);
    }
}

/// There is no water farther below the bed than the waves are high: from there on down nothing changes, so
/// that nothing overflows.
void AiryWaves::expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const {
    const WavesAtTime waves = wavesAt(time);
    const auto sumHead = waveKernels().head;
    const double deepest = -m_depth - m_bounds.elevation;
    double sums[10];
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const double height = points(row, 2);
        sumHead(waves, points(row, 0), points(row, 1), std::max(height, deepest), sums);
        expansions.row(row) = Eigen::Map<const Eigen::Array<double, 1, 10>>(sums);
        if (height < deepest)
            for (int alongS : {3, 7, 8, 9})
                expansions(row, alongS) = 0;
    }
}

/// Along a straight line of unit direction each component is the real part of a e^w, or half the sum of two
/// such, with w = i theta + k s or i theta - k s and s = z - eta. With the surface's slope m, |w'| <= k v,
/// where v = (m + sqrt(m^2 + 4)) / 2 is the largest stretch of the shear (x, z) -> (x, z - m x); |w''| <= k
/// |eta''| and |w'''| <= k |eta'''|. The third derivative of e^w is (w'^3 + 3 w' w'' + w''') e^w.
double AiryWaves::headCurvatureChangeUnder(const WaterBounds& surface, double above) const {
    const double stretch = (surface.slope + std::sqrt(surface.slope * surface.slope + 4)) / 2;
    double bound = 0;
    for (const WaveComponent& wave : m_components) {
        if (wave.amplitude == 0) continue;
        const double k = wave.wavenumber, deep = std::exp(-2 * k * m_depth);
        double largest = std::exp(k * above);
        if (!std::isinf(m_depth)) {
            const double fromBed = std::max(m_bounds.elevation, std::abs(m_depth + above));
            largest = std::exp(k * (fromBed - m_depth)) * (1 + std::exp(-2 * k * fromBed)) / (1 + deep);
        }
        bound += wave.amplitude * largest * k *
                 (k * k * stretch * stretch * stretch + 3 * k * stretch * surface.curvature +
                  surface.curvatureChange);
    }
    return bound;
}

void AiryWaves::sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const {
    const WavesAtTime waves = wavesAt(time);
    const WaveKernels& kernels = waveKernels();
    double surface[3], velocity[3];
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        kernels.surface(waves, points(row, 0), points(row, 1), surface);
        const double s = std::max(std::min(points(row, 2) - surface[0], 0.0), -m_depth);
        kernels.velocity(waves, points(row, 0), points(row, 1), s, velocity);
        velocities.row(row) = Eigen::Map<const Eigen::Array<double, 1, 3>>(velocity);
    }
}

}  // namespace bullet_buoyancy
