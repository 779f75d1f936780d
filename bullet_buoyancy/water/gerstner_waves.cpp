#include "bullet_buoyancy/water/gerstner_waves.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/water/trochoid.h"

namespace bullet_buoyancy {

namespace {

/// What an extrapolated slope may be off by, m/m: no more than curvature's change times the distance's
/// square.
constexpr double slopeTolerance = 1e-8;

/// How far second derivatives are taken over unchanged, m: they are then off by as many times their change.
constexpr double bendReach = 1e-9;

WaterStatus check(const std::vector<WaveComponent>& components) {
    WaterStatus status = checkComponents(components);
    if (!status.accepted()) return status;
    status.steepness = waveMoment(components, 1);
    if (!(status.steepness < 1)) status.error = WaterError::loopedCrest;
    return status;
}

/// With the steepness s, derivatives of the resting place by the place are at most j = 1 / (1 - s). For the
/// second and third derivatives of the elevation along a line, derive it twice and thrice through the resting
/// place, with |cos + slope sin| <= sqrt(1 + (s j)^2) <= j.
WaterBounds boundsOf(const std::vector<WaveComponent>& components) {
    const double j = 1 / (1 - waveMoment(components, 1));
    const double second = waveMoment(components, 2), third = waveMoment(components, 3);
    WaterBounds bounds;
    bounds.elevation = waveMoment(components, 0);
    bounds.slope = waveMoment(components, 1) * j;
    bounds.curvature = second * std::pow(j, 3);
    bounds.curvatureChange = third * std::pow(j, 4) + 3 * second * second * std::pow(j, 5);
    bounds.still = bounds.elevation == 0;
    return bounds;
}

/// A particle under the surface, seen from a point.
struct DeepParticle {
    Vec3 rest = Vec3::Zero();   // height below zero
    Vec3 shift = Vec3::Zero();  // from the point to the particle
    Mat3 placeFromRest = Mat3::Identity();
    Vec3 velocity = Vec3::Zero();
};

DeepParticle deepParticle(const std::vector<WaveLanes>& waves, double time, const Vec3& rest,
                          const Vec3& point) {
    Lanes sine, cosine;
    Lanes x = Lanes::Zero(), y = x, z = x, xx = x, xy = x, yy = x, xz = x, yz = x, u = x, v = x, w = x;
    for (const WaveLanes& eight : waves) {
        eight.sinCosAt(rest.x(), rest.y(), time, sine, cosine);
        const Lanes decay = (eight.wavenumber * rest.z()).exp();
        sine *= decay;
        cosine *= decay;
        x -= eight.amplitudeX * sine;
        y -= eight.amplitudeY * sine;
        z += eight.amplitude * cosine;
        xx += eight.amplitudeX * eight.wavenumberX * cosine;
        xy += eight.amplitudeX * eight.wavenumberY * cosine;
        yy += eight.amplitudeY * eight.wavenumberY * cosine;
        xz += eight.amplitude * eight.wavenumberX * sine;
        yz += eight.amplitude * eight.wavenumberY * sine;
        u += eight.amplitudeX * eight.frequency * cosine;
        v += eight.amplitudeY * eight.frequency * cosine;
        w += eight.amplitude * eight.frequency * sine;
    }
    DeepParticle result;
    result.rest = rest;
    result.shift = rest + Vec3(x.sum(), y.sum(), z.sum()) - point;
    const double upX = -xz.sum(), upY = -yz.sum(), plane = -xy.sum();
    result.placeFromRest << 1 - xx.sum(), plane, upX,  //
        plane, 1 - yy.sum(), upY,                      //
        upX, upY, 1 + xx.sum() + yy.sum();
    result.velocity = {u.sum(), v.sum(), w.sum()};
    return result;
}

/// Newton's method, with the step halved while it does not come nearer. The derivative is symmetric and
/// positive definite, as at the surface.
DeepParticle findParticle(const std::vector<WaveLanes>& waves, double time, const Vec3& start,
                          const Vec3& point) {
    DeepParticle best = deepParticle(waves, time, start, point);
    Vec3 step = -best.placeFromRest.inverse() * best.shift;
    for (int look = 1; look < 50 && best.shift.squaredNorm() > 1e-20; ++look) {
        Vec3 rest = best.rest + step;
        rest.z() = std::min(rest.z(), 0.0);
        const DeepParticle next = deepParticle(waves, time, rest, point);
        if (next.shift.squaredNorm() < best.shift.squaredNorm()) {
            best = next;
            step = -best.placeFromRest.inverse() * best.shift;
        } else {
            step /= 2;
        }
    }
    return best;
}

}  // namespace

GerstnerWaves::GerstnerWaves(const WaterFrame& frame, const GerstnerWavesDef& def)
    : WaterField(frame, def.density), m_status(check(def.components)) {
    const auto components = m_status.accepted() ? def.components : std::vector<WaveComponent>();
    m_lanes = waveLanes(components);
    m_bounds = boundsOf(components);
    m_steepness = waveMoment(components, 1);
    m_reach = std::sqrt(slopeTolerance / m_bounds.curvatureChange);
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

/// The second derivatives are P^T Q P with P the derivative of the resting place by the place and Q the sum
/// of -amplitude k k^T (cos(theta) + (slope . k / |k|) sin(theta)).
void GerstnerWaves::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const Trochoid at = findTrochoid(m_lanes, time, {points(row, 0), points(row, 1)}, bendReach);
        const Vec2 slope = at.slope();
        const Vec3 q = -at.sag - at.bend.head<3>() * slope.x() - at.bend.tail<3>() * slope.y();
        Eigen::Matrix2d bend;
        bend << q[0], q[1], q[1], q[2];
        const Eigen::Matrix2d restFromPlace = at.restFromPlace();
        bend = restFromPlace.transpose() * bend * restFromPlace;
        expansions.row(row) << at.elevation, slope.x(), slope.y(), bend(0, 0), bend(0, 1), bend(1, 1),
            m_bounds.curvatureChange;
    }
}

void GerstnerWaves::sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const Vec3 point(points(row, 0), points(row, 1), points(row, 2));
        const Trochoid top = findTrochoid(m_lanes, time, point.head<2>(), m_reach);
        const double depth = std::max(top.elevation - point.z(), 0.0);
        const Vec3 start(top.rest.x(), top.rest.y(), -depth);
        const DeepParticle particle = depth == 0 ? deepParticle(m_lanes, time, start, point)
                                                 : findParticle(m_lanes, time, start, point);
        velocities.row(row) = particle.velocity.transpose().array();
    }
}

}  // namespace bullet_buoyancy
