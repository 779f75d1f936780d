#include "bullet_buoyancy/water/airy_waves.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/exp.h"
#include "bullet_buoyancy/water/third_derivative.h"

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
    m_lanes = waveLanes(m_components);
    m_bounds = boundsOf(m_components);
    m_depthLanes.resize(m_lanes.size());
    for (std::size_t i = 0; i < m_components.size(); ++i) {
        const WaveComponent& wave = m_components[i];
        const auto lane = Eigen::Index(i % laneCount);
        m_depthLanes[i / laneCount].evenShare[lane] = 1 / (1 + std::exp(-2 * wave.wavenumber * m_depth));
        m_depthLanes[i / laneCount].orbit[lane] = wave.frequency / std::tanh(wave.wavenumber * m_depth);
    }
}

/// cosh k(depth + s) / cosh(k depth) and sinh k(depth + s) / cosh(k depth). There is no water farther below
/// the bed than the waves are high: from there on down nothing changes, so that nothing overflows.
void AiryWaves::decay(std::size_t lane, double s, Lanes& even, Lanes& odd) const {
    const WaveLanes::Stored& wavenumber = m_lanes[lane].wavenumber;
    const Lanes up = expOf<laneCount>(wavenumber * s);
    even = odd = up;
    if (std::isinf(m_depth)) return;
    const Lanes down = expOf<laneCount>(wavenumber * (-2 * m_depth - s));
    even = (up + down) * m_depthLanes[lane].evenShare;
    odd = (up - down) * m_depthLanes[lane].evenShare;
}

void AiryWaves::sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const {
    Lanes sine, cosine;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        Lanes elevation = Lanes::Zero(), slopeX = Lanes::Zero(), slopeY = Lanes::Zero();
        for (const WaveLanes& waves : m_lanes) {
            waves.sinCosAt(points(row, 0), points(row, 1), time, sine, cosine);
            const Lanes height = waves.amplitude * sine;
            elevation += waves.amplitude * cosine;
            slopeX -= waves.wavenumberX * height;
            slopeY -= waves.wavenumberY * height;
        }
        samples.row(row) << elevation.sum(), slopeX.sum(), slopeY.sum();
    }
}

void AiryWaves::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    Lanes sine, cosine;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        Lanes elevation = Lanes::Zero(), slopeX = elevation, slopeY = elevation;
        Lanes bendXX = elevation, bendXY = elevation, bendYY = elevation;
        Lanes thirdXXX = elevation, thirdXXY = elevation, thirdXYY = elevation, thirdYYY = elevation;
        for (const WaveLanes& waves : m_lanes) {
            waves.sinCosAt(points(row, 0), points(row, 1), time, sine, cosine);
            sine *= waves.amplitude;
            cosine *= waves.amplitude;
            elevation += cosine;
            slopeX -= waves.wavenumberX * sine;
            slopeY -= waves.wavenumberY * sine;
            const Lanes squareX = waves.wavenumberX * waves.wavenumberX,
                        product = waves.wavenumberX * waves.wavenumberY,
                        squareY = waves.wavenumberY * waves.wavenumberY;
            bendXX -= squareX * cosine;
            bendXY -= product * cosine;
            bendYY -= squareY * cosine;
            thirdXXX += squareX * waves.wavenumberX * sine;
            thirdXXY += squareX * waves.wavenumberY * sine;
            thirdXYY += squareY * waves.wavenumberX * sine;
            thirdYYY += squareY * waves.wavenumberY * sine;
        }
        expansions.row(row) << elevation.sum(), slopeX.sum(), slopeY.sum(), bendXX.sum(), bendXY.sum(),
            bendYY.sum(),
            largestThirdDerivative(thirdXXX.sum(), thirdXXY.sum(), thirdXYY.sum(), thirdYYY.sum());
    }
}

void AiryWaves::expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const {
    Lanes sine, cosine, even, odd;
    const double deepest = -m_depth - m_bounds.elevation;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        Lanes head = Lanes::Zero(), x = head, y = head, s = head;
        Lanes xx = head, xy = head, yy = head, xs = head, ys = head, ss = head;
        const double height = points(row, 2);
        const double varies = height < deepest ? 0 : 1;
        for (std::size_t i = 0; i < m_lanes.size(); ++i) {
            const WaveLanes& waves = m_lanes[i];
            waves.sinCosAt(points(row, 0), points(row, 1), time, sine, cosine);
            decay(i, std::max(height, deepest), even, odd);
            even *= waves.amplitude;
            odd *= varies * waves.amplitude * waves.wavenumber;
            const Lanes bend = cosine * even, tilt = sine * even, lift = sine * odd;
            head += bend;
            x -= waves.wavenumberX * tilt;
            y -= waves.wavenumberY * tilt;
            s += cosine * odd;
            xx -= waves.wavenumberX * waves.wavenumberX * bend;
            xy -= waves.wavenumberX * waves.wavenumberY * bend;
            yy -= waves.wavenumberY * waves.wavenumberY * bend;
            xs -= waves.wavenumberX * lift;
            ys -= waves.wavenumberY * lift;
            ss += varies * waves.wavenumber * waves.wavenumber * bend;
        }
        expansions.row(row) << head.sum(), x.sum(), y.sum(), s.sum(), xx.sum(), xy.sum(), yy.sum(), xs.sum(),
            ys.sum(), ss.sum();
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
    Lanes sine, cosine, even, odd;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        Lanes elevation = Lanes::Zero(), velocityX = elevation, velocityY = elevation, velocityZ = elevation;
        for (const WaveLanes& waves : m_lanes) {
            waves.sinCosAt(points(row, 0), points(row, 1), time, sine, cosine);
            elevation += waves.amplitude * cosine;
        }
        const double s = std::max(std::min(points(row, 2) - elevation.sum(), 0.0), -m_depth);
        for (std::size_t i = 0; i < m_lanes.size(); ++i) {
            const WaveLanes& waves = m_lanes[i];
            waves.sinCosAt(points(row, 0), points(row, 1), time, sine, cosine);
            decay(i, s, even, odd);
            const Lanes along = m_depthLanes[i].orbit * even * cosine;
            velocityX += waves.amplitudeX * along;
            velocityY += waves.amplitudeY * along;
            velocityZ += waves.amplitude * m_depthLanes[i].orbit * odd * sine;
        }
        velocities.row(row) << velocityX.sum(), velocityY.sum(), velocityZ.sum();
    }
}

}  // namespace bullet_buoyancy
