#include "bullet_buoyancy/water/trochoid.h"

#include <Eigen/LU>

namespace bullet_buoyancy {

namespace {

/// From here on a particle is near enough to its place, m: rounding may keep it from coming nearer.
constexpr double placeTolerance = 1e-10;

/// Seas at a steepness of 0.99 need no more than some twenty.
constexpr int mostLooks = 100;

Eigen::Matrix2d symmetric(double xx, double xy, double yy) {
    return (Eigen::Matrix2d() << xx, xy, xy, yy).finished();
}

Eigen::Matrix2d placeFromRest(const Trochoid& at) {
    return symmetric(1 - at.squeeze[0], -at.squeeze[1], 1 - at.squeeze[2]);
}

Vec2 solve(const Eigen::Matrix2d& matrix, const Vec2& right) {
    return matrix.inverse() * right;
}

/// Newton's step.
Vec2 firstOrderStep(const Trochoid& at) {
    return -solve(placeFromRest(at), at.shift);
}

/// Halley's step: as Newton's, but with the derivative in the middle of Newton's step. Falls back to that
/// where the curvature is too strong to be extrapolated.
Vec2 secondOrderStep(const Trochoid& at) {
    const Vec2 newton = firstOrderStep(at), half = newton / 2;
    const Eigen::Matrix2d derivative = placeFromRest(at);
    const Eigen::Matrix2d inMiddle = derivative + symmetric(at.bend[0] * half.x() + at.bend[1] * half.y(),
                                                            at.bend[1] * half.x() + at.bend[2] * half.y(),
                                                            at.bend[2] * half.x() + at.bend[3] * half.y());
    const bool tame = inMiddle.trace() > 0 && inMiddle.determinant() > 0.25 * derivative.determinant();
    return tame ? Vec2(-solve(inMiddle, at.shift)) : newton;
}

/// The particle that rests `step` farther on, and has arrived at its place.
Trochoid moved(Trochoid at, const Vec2& step) {
    const Eigen::Matrix2d sag = symmetric(at.sag[0], at.sag[1], at.sag[2]);
    at.rest += step;
    at.shift.setZero();
    at.elevation += at.gradient.dot(step) - step.dot(sag * step) / 2;
    at.gradient -= sag * step;
    at.squeeze -= at.bend.head<3>() * step.x() + at.bend.tail<3>() * step.y();
    return at;
}

/// The particle that rests at `rest`, seen from `place`.
Trochoid trochoidAt(const std::vector<WaveLanes>& waves, double time, const Vec2& rest, const Vec2& place) {
    // Two lanes at a time: their sums nearly fit into the registers of any machine with vectors.
    using Pair = Eigen::Array2d;
    Lanes sine, cosine;
    Pair x = Pair::Zero(), y = x, z = x, dx = x, dy = x, xx = x, xy = x, yy = x;
    Pair sagXX = x, sagXY = x, sagYY = x, xxx = x, xxy = x, xyy = x, yyy = x;
    for (const WaveLanes& group : waves) {
        group.sinCosAt(rest.x(), rest.y(), time, sine, cosine);
        for (int lane = 0; lane < laneCount; lane += 2) {
            const Pair kx = group.wavenumberX.segment<2>(lane), ky = group.wavenumberY.segment<2>(lane);
            const Pair ax = group.amplitudeX.segment<2>(lane), ay = group.amplitudeY.segment<2>(lane);
            const Pair s = sine.segment<2>(lane), c = cosine.segment<2>(lane);
            const Pair a = group.amplitude.segment<2>(lane), height = a * s;
            z += a * c;
            dx -= kx * height;
            dy -= ky * height;
            const Pair sagX = kx * a * c, sagY = ky * a * c;
            sagXX += kx * sagX;
            sagXY += ky * sagX;
            sagYY += ky * sagY;
            const Pair alongX = ax * c, alongY = ay * c, shiftX = ax * s, shiftY = ay * s;
            x += shiftX;
            y += shiftY;
            xx += kx * alongX;
            xy += ky * alongX;
            yy += ky * alongY;
            const Pair bendX = kx * shiftX, bendY = ky * shiftY;
            xxx += kx * bendX;
            xxy += ky * bendX;
            xyy += kx * bendY;
            yyy += ky * bendY;
        }
    }
    Trochoid result;
    result.rest = rest;
    result.shift = rest - Vec2(x.sum(), y.sum()) - place;
    result.elevation = z.sum();
    result.gradient = {dx.sum(), dy.sum()};
    result.sag = {sagXX.sum(), sagXY.sum(), sagYY.sum()};
    result.squeeze = {xx.sum(), xy.sum(), yy.sum()};
    result.bend = {xxx.sum(), xxy.sum(), xyy.sum(), yyy.sum()};
    return result;
}

}  // namespace

Eigen::Matrix2d Trochoid::restFromPlace() const {
    return placeFromRest(*this).inverse();
}

Vec2 Trochoid::slope() const {
    return restFromPlace() * gradient;
}

Trochoid findTrochoid(const std::vector<WaveLanes>& waves, double time, const Vec2& place, double reach) {
    const double near = placeTolerance + 1e-15 * place.norm();
    Trochoid best = trochoidAt(waves, time, place, place);
    Vec2 step = secondOrderStep(best);
    bool fresh = true;
    for (int look = 1; look < mostLooks; ++look) {
        if (fresh && (step.squaredNorm() <= reach * reach || best.shift.squaredNorm() <= near * near)) break;
        const Trochoid next = trochoidAt(waves, time, best.rest + step, place);
        if (next.shift.squaredNorm() < best.shift.squaredNorm()) {
            best = next;
            step = secondOrderStep(best);
            fresh = true;
        } else {
            // Some part of Newton's step always comes nearer.
            step = fresh ? Vec2(firstOrderStep(best) / 2) : Vec2(step / 2);
            fresh = false;
        }
    }
    return moved(best, step);
}

}  // namespace bullet_buoyancy
