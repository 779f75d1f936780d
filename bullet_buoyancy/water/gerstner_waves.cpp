#include "bullet_buoyancy/water/gerstner_waves.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/exp.h"
#include "bullet_buoyancy/water/trochoid.h"

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

DeepParticle deepParticle(const std::vector<WaveLanes>& waves, double time, const Vec3& rest,
                          const Vec3& point) {
    using Pair = Eigen::Array2d;  // two lanes at a time, as for trochoids
    Lanes sine, cosine;
    Pair x = Pair::Zero(), y = x, z = x, xx = x, xy = x, yy = x, xz = x, yz = x;
    Pair u = x, v = x, w = x, ux = x, uy = x, vy = x, uz = x, vz = x;
    for (const WaveLanes& group : waves) {
        group.sinCosAt(rest.x(), rest.y(), time, sine, cosine);
        const Lanes decay = expOf<laneCount>(group.wavenumber * rest.z());
        sine *= decay;
        cosine *= decay;
        for (int lane = 0; lane < laneCount; lane += 2) {
            const Pair kx = group.wavenumberX.segment<2>(lane), ky = group.wavenumberY.segment<2>(lane);
            const Pair ax = group.amplitudeX.segment<2>(lane), ay = group.amplitudeY.segment<2>(lane);
            const Pair frequency = group.frequency.segment<2>(lane), a = group.amplitude.segment<2>(lane);
            const Pair s = sine.segment<2>(lane), c = cosine.segment<2>(lane), up = a * c, back = a * s;
            const Pair backX = ax * s, backY = ay * s, upX = ax * c, upY = ay * c;
            x -= backX;
            y -= backY;
            z += up;
            xx -= kx * upX;
            xy -= ky * upX;
            yy -= ky * upY;
            xz -= kx * back;
            yz -= ky * back;
            u += frequency * upX;
            v += frequency * upY;
            w += frequency * back;
            const Pair rateX = frequency * kx, rateY = frequency * ky;
            ux -= rateX * backX;
            uy -= rateY * backX;
            vy -= rateY * backY;
            uz += rateX * up;
            vz += rateY * up;
        }
    }
    return {rest, rest + Vec3(x.sum(), y.sum(), z.sum()) - point,
            Mat3::Identity() + symmetricWithoutTrace(xx.sum(), xy.sum(), yy.sum(), xz.sum(), yz.sum()),
            Vec3(u.sum(), v.sum(), w.sum()),
            symmetricWithoutTrace(ux.sum(), uy.sum(), vy.sum(), uz.sum(), vz.sum())};
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
Vec3 velocityAt(const std::vector<WaveLanes>& waves, double time, const Vec3& start, const Vec3& point,
                double reach) {
    const auto look = [&](Vec3 rest) {
        rest.z() = std::min(rest.z(), 0.0);
        return deepParticle(waves, time, rest, point);
    };
    DeepParticle best = look(start);
    Vec3 step = -best.placeFromRest.inverse() * best.shift;
    bool fresh = true;
    for (int looks = 1; looks < 50 && !(fresh && step.squaredNorm() <= reach * reach); ++looks) {
        const DeepParticle next = look(best.rest + step);
        fresh = next.shift.squaredNorm() < best.shift.squaredNorm();
        if (fresh) best = next;
        step = fresh ? Vec3(-best.placeFromRest.inverse() * best.shift) : Vec3(step / 2);
    }
    return best.velocity + best.velocityFromRest * step;
}

}  // namespace

GerstnerWaves::GerstnerWaves(const WaterFrame& frame, const GerstnerWavesDef& def)
    : WaterField(frame, def.density), m_status(check(def.components)) {
    const auto components = m_status.accepted() ? def.components : std::vector<WaveComponent>();
    m_lanes = waveLanes(components);
    m_bounds = boundsOf(components);
    m_steepness = waveMoment(components, 1);
    m_reach = std::sqrt(slopeTolerance / std::max(m_bounds.curvatureChange, m_bounds.curvatureChangeGrowth));
    setReachOfVelocity(components);
    for (const WaveComponent& wave : components)
        m_meanLevel -= wave.amplitude * wave.amplitude * wave.wavenumber / 2;
}

void GerstnerWaves::sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const Trochoid at = findTrochoid(m_lanes, time, {points(row, 0), points(row, 1)}, m_reach);
        const Vec2 slope = at.slope();
        samples.row(row) << at.elevation, slope.x(), slope.y();
    }
}

/// The third derivative is that at a particle, which is no farther than twice `m_reach`.
void GerstnerWaves::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const Trochoid at = findBentTrochoid(m_lanes, time, {points(row, 0), points(row, 1)}, m_reach);
        const Vec2 slope = at.slope();
        const SurfaceBend bend = surfaceBend(at);
        const double third = bend.third + 2 * m_reach * m_bounds.curvatureChangeGrowth;
        expansions.row(row) << at.elevation, slope.x(), slope.y(), bend.second(0, 0), bend.second(0, 1),
            bend.second(1, 1), std::min(third, m_bounds.curvatureChange);
    }
}

void GerstnerWaves::sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        Vec3 point(points(row, 0), points(row, 1), points(row, 2));
        const Trochoid top = findTrochoid(m_lanes, time, point.head<2>(), m_reachFromTop);
        point.z() = std::min(point.z(), top.elevation);
        const Vec3 start = restBelow(top, point, top.elevation - point.z(), m_meanWavenumber);
        velocities.row(row) = velocityAt(m_lanes, time, start, point, m_reachUnder).transpose().array();
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
