#include "bullet_buoyancy/water/gerstner_waves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/water/pack_waves.h"
#include "bullet_buoyancy/water/trochoid.h"
#include "bullet_buoyancy/water/wave_kernels.h"

namespace bullet_buoyancy {

namespace {

/// What extrapolated slopes (m/m) and second derivatives (1/m) may be off by: no more than the change of the
/// curvature, or that change's growth, times the distance's square.
constexpr double slopeTolerance = 1e-8;

/// What velocities may be off by, over the sum of all waves' orbital speeds.
constexpr double velocityTolerance = 1e-4;

WaterStatus check(const std::vector<WaveComponent>& components) {
    WaterStatus status = checkComponents(components);
    if (!status.accepted()) return status;
    status.steepness = waveMoment(components, 1);
    if (!(status.steepness < 1)) status.error = WaterError::loopedCrest;
    return status;
}

/// With the steepness s, derivatives of the resting place by the place are at most j = 1 / (1 - s). For the
/// second to fourth derivatives of the elevation along a line, derive it so often through the resting place,
/// with |cos + slope sin| <= sqrt(1 + (s j)^2) <= j.
WaterBounds boundsOf(const std::vector<WaveComponent>& components) {
    const double j = 1 / (1 - waveMoment(components, 1));
    const double second = waveMoment(components, 2), third = waveMoment(components, 3),
                 fourth = waveMoment(components, 4);
    WaterBounds bounds;
    bounds.elevation = waveMoment(components, 0);
    bounds.slope = waveMoment(components, 1) * j;
    bounds.curvature = second * std::pow(j, 3);
    bounds.curvatureChange = third * std::pow(j, 4) + 3 * second * second * std::pow(j, 5);
    bounds.curvatureChangeGrowth = fourth * std::pow(j, 5) + 10 * second * third * std::pow(j, 6) +
                                   15 * std::pow(second, 3) * std::pow(j, 7);
    bounds.still = bounds.elevation == 0;
    return bounds;
}

/// A particle under the surface, seen from a point.
struct DeepParticle {
    Vec3 rest;   // height below zero
    Vec3 shift;  // from the point to the particle
    Mat3 placeFromRest;
    Vec3 velocity;
    Mat3 velocityFromRest;
};

Mat3 symmetricWithoutTrace(double xx, double xy, double yy, double xz, double yz) {
    return (Mat3() << xx, xy, xz, xy, yy, yz, xz, yz, -xx - yy).finished();
}

DeepParticle deepParticle(const WavesAtTime& waves, const Vec3& rest, const Vec3& point) {
    double sums[16];
    waveKernels().particle(waves, rest.x(), rest.y(), rest.z(), sums);
    const auto& [x, y, z, xx, xy, yy, xz, yz, u, v, w, ux, uy, vy, uz, vz] = sums;
    return {rest, rest + Vec3(x, y, z) - point, Mat3::Identity() + symmetricWithoutTrace(xx, xy, yy, xz, yz),
            Vec3(u, v, w), symmetricWithoutTrace(ux, uy, vy, uz, vz)};
}

/// By Cramer's rule.
Vec3 solve(const Mat3& matrix, const Vec3& right) {
    const Vec3 x = matrix.col(0), y = matrix.col(1), z = matrix.col(2), yz = y.cross(z);
    return Vec3(right.dot(yz), right.dot(z.cross(x)), right.dot(x.cross(y))) / x.dot(yz);
}

/// Where the particle at a point `depth` (m) below that of the surface may rest: orbits shrink as those of
/// waves of one wavenumber do, but for what their derivative at the surface tells.
Vec3 restBelow(const Trochoid& top, const Vec3& point, double depth, double wavenumber) {
    Vec3 orbit, orbitGrows;
    orbit << point.head<2>() - top.rest, top.elevation;
    orbitGrows << top.gradient, top.squeeze[0] + top.squeeze[2];
    return point - std::exp(-wavenumber * depth) * (orbit - depth * (orbitGrows - wavenumber * orbit));
}

/// Of the particle at the point, by Newton's method, with the step halved while it does not come nearer,
/// until it is no farther than `reach` (m): the velocity's derivative tells the rest. That of the place is
/// symmetric and positive definite, as at the surface.
Vec3 velocityAt(const WavesAtTime& waves, const Vec3& start, const Vec3& point, double reach) {
    const auto look = [&](Vec3 rest) {
        rest.z() = std::min(rest.z(), 0.0);
        return deepParticle(waves, rest, point);
    };
    DeepParticle best = look(start);
    Vec3 step = -solve(best.placeFromRest, best.shift);
    bool fresh = true;
    for (int looks = 1; looks < 50 && !(fresh && step.squaredNorm() <= reach * reach); ++looks) {
        const DeepParticle next = look(best.rest + step);
        fresh = next.shift.squaredNorm() < best.shift.squaredNorm();
        if (fresh) best = next;
        step = fresh ? Vec3(-solve(best.placeFromRest, best.shift)) : Vec3(step / 2);
    }
    return best.velocity + best.velocityFromRest * step;
}

}  // namespace

GerstnerWaves::GerstnerWaves(const WaterFrame& frame, const GerstnerWavesDef& def)
    : WaterField(frame, def.density), m_status(check(def.components)) {
    const auto components = m_status.accepted() ? def.components : std::vector<WaveComponent>();
    m_lanes = packWaves(components);
    m_bounds = boundsOf(components);
    m_steepness = waveMoment(components, 1);
    m_reach = std::sqrt(slopeTolerance / std::max(m_bounds.curvatureChange, m_bounds.curvatureChangeGrowth));
    setReachOfVelocity(components);
    for (const WaveComponent& wave : components)
        m_meanLevel -= wave.amplitude * wave.amplitude * wave.wavenumber / 2;
}

WavesAtTime GerstnerWaves::wavesAt(double time) const {
    return {m_lanes.data(), int(m_lanes.size()), time, std::numeric_limits<double>::infinity()};
}

void GerstnerWaves::sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const {
    const WavesAtTime waves = wavesAt(time);
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const Trochoid at = findTrochoid(waves, {points(row, 0), points(row, 1)}, m_reach);
        const Vec2 slope = at.slope();
        samples.row(row) << at.elevation, slope.x(), slope.y();
    }
}

/// The third derivative is that at a particle, which is no farther than twice `m_reach`.
void GerstnerWaves::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    const WavesAtTime waves = wavesAt(time);
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const Trochoid at = findBentTrochoid(waves, {points(row, 0), points(row, 1)}, m_reach);
        const SurfaceBend bend = surfaceBend(at);
        const double third = bend.third + 2 * m_reach * m_bounds.curvatureChangeGrowth;
        expansions.row(row) << at.elevation, bend.slope.x(), bend.slope.y(), bend.second[0], bend.second[1],
            bend.second[2], std::min(third, m_bounds.curvatureChange);
    }
}

/// A first look at the surface tells where to look for the particle, unless that may be above the surface.
void GerstnerWaves::sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const {
    const WavesAtTime waves = wavesAt(time);
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        Vec3 point(points(row, 0), points(row, 1), points(row, 2));
        const Vec2 place = point.head<2>();
        Trochoid top = findTrochoid(waves, place, std::numeric_limits<double>::infinity());
        const double misplaced = m_bounds.curvature * (top.rest - place).squaredNorm();
        if (top.elevation - point.z() < misplaced) top = findTrochoid(waves, place, m_reachFromTop);
        point.z() = std::min(point.z(), top.elevation);
        const Vec3 start = restBelow(top, point, top.elevation - point.z(), m_meanWavenumber);
        velocities.row(row) = velocityAt(waves, start, point, m_reachUnder).transpose().array();
    }
}

/// Half of the tolerance is for what the velocity's derivative does not tell, and for what Newton's last step
/// misses; half for the height of the surface, to which points above it are lowered.
void GerstnerWaves::setReachOfVelocity(const std::vector<WaveComponent>& components) {
    double speed = 0, change = 0, bend = 0;  // sums of the orbits' speeds and of their derivatives
    for (const WaveComponent& wave : components) {
        const double ofWave = wave.amplitude * wave.frequency;
        speed += ofWave;
        change += ofWave * wave.wavenumber;
        bend += ofWave * wave.wavenumber * wave.wavenumber;
    }
    if (speed == 0) return;
    const double allowed = velocityTolerance * speed / 2, j = 1 / (1 - m_steepness);
    m_reachUnder = std::sqrt(2 * allowed / (bend + j * change * waveMoment(components, 2)));
    m_reachFromTop = std::cbrt(6 * allowed / (change * m_bounds.curvatureChange));
    m_meanWavenumber = m_steepness / m_bounds.elevation;
}

}  // namespace bullet_buoyancy
