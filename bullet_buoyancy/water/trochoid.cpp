#include "bullet_buoyancy/water/trochoid.h"

#include <Eigen/LU>

#include "bullet_buoyancy/water/third_derivative.h"

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

/// A symmetric form of three vectors with one of them put in: that of the other two.
Eigen::Matrix2d along(const Eigen::Vector4d& cubic, const Vec2& vector) {
    const Vec3 form = cubic.head<3>() * vector.x() + cubic.tail<3>() * vector.y();
    return symmetric(form[0], form[1], form[2]);
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
    const Eigen::Matrix2d inMiddle = derivative + along(at.bend, half);
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
    at.sag -= at.sagFalls.head<3>() * step.x() + at.sagFalls.tail<3>() * step.y();
    at.bend += at.bendRises.head<4>() * step.x() + at.bendRises.tail<4>() * step.y();
    return at;
}

/// The particle that rests at `rest`, seen from `place`; with its third derivatives or with zeros for them.
template <bool withThird>
Trochoid trochoidAt(const std::vector<WaveLanes>& waves, double time, const Vec2& rest, const Vec2& place) {
    // Two lanes at a time: their sums nearly fit into the registers of any machine with vectors.
    using Pair = Eigen::Array2d;
    Lanes sine, cosine;
    Pair x = Pair::Zero(), y = x, z = x, dx = x, dy = x, xx = x, xy = x, yy = x;
    Pair sagXX = x, sagXY = x, sagYY = x, xxx = x, xxy = x, xyy = x, yyy = x;
    Pair fallsXXX = x, fallsXXY = x, fallsXYY = x, fallsYYY = x;
    Pair xxxx = x, xxxy = x, xxyy = x, xyyy = x, yyyy = x;
    for (const WaveLanes& group : waves) {
        group.sinCosAt(rest.x(), rest.y(), time, sine, cosine);
        for (int lane = 0; lane < laneCount; lane += 2) {
            const Pair kx = group.wavenumberX.segment<2>(lane), ky = group.wavenumberY.segment<2>(lane);
            const Pair ax = group.amplitudeX.segment<2>(lane), ay = group.amplitudeY.segment<2>(lane);
            const Pair s = sine.segment<2>(lane), c = cosine.segment<2>(lane);
            const Pair a = group.amplitude.segment<2>(lane), height = a * s;
            z += a * c;
            const Pair steepX = kx * height, steepY = ky * height;
            dx -= steepX;
            dy -= steepY;
            const Pair sagX = kx * a * c, sagY = ky * a * c;
            sagXX += kx * sagX;
            sagXY += ky * sagX;
            sagYY += ky * sagY;
            const Pair alongX = ax * c, alongY = ay * c, shiftX = ax * s, shiftY = ay * s;
            x += shiftX;
            y += shiftY;
            const Pair squeezeX = kx * alongX, squeezeY = ky * alongY;
            xx += squeezeX;
            xy += ky * alongX;
            yy += squeezeY;
            const Pair bendX = kx * shiftX, bendY = ky * shiftY;
            xxx += kx * bendX;
            xxy += ky * bendX;
            xyy += kx * bendY;
            yyy += ky * bendY;
            if constexpr (withThird) {
                const Pair kxx = kx * kx, kxy = kx * ky, kyy = ky * ky;
                fallsXXX += kxx * steepX;
                fallsXXY += kxy * steepX;
                fallsXYY += kxy * steepY;
                fallsYYY += kyy * steepY;
                xxxx += kxx * squeezeX;
                xxxy += kxy * squeezeX;
                xxyy += kyy * squeezeX;
                xyyy += kxy * squeezeY;
                yyyy += kyy * squeezeY;
            }
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
    result.sagFalls = {fallsXXX.sum(), fallsXXY.sum(), fallsXYY.sum(), fallsYYY.sum()};
    result.bendRises << xxxx.sum(), xxxy.sum(), xxyy.sum(), xyyy.sum(), yyyy.sum();
    return result;
}

/// The last look at least has third derivatives if they are wanted: the first one, which begins far off, has
/// none.
template <bool withThird>
Trochoid find(const std::vector<WaveLanes>& waves, double time, const Vec2& place, double reach) {
    const double near = placeTolerance + 1e-15 * place.norm();
    Trochoid best = trochoidAt<false>(waves, time, place, place);
    Vec2 step = secondOrderStep(best);
    bool fresh = true, complete = !withThird;
    for (int look = 1; look < mostLooks; ++look) {
        const bool arrived = step.squaredNorm() <= reach * reach || best.shift.squaredNorm() <= near * near;
        if (fresh && complete && arrived) break;
        const Trochoid next = trochoidAt<withThird>(waves, time, best.rest + step, place);
        if (!complete || next.shift.squaredNorm() < best.shift.squaredNorm()) {
            best = next;
            step = secondOrderStep(best);
            fresh = complete = true;
        } else {
            // Some part of Newton's step always comes nearer.
            step = fresh ? Vec2(firstOrderStep(best) / 2) : Vec2(step / 2);
            fresh = false;
        }
    }
    return moved(best, step);
}

}  // namespace

Eigen::Matrix2d Trochoid::restFromPlace() const {
    return placeFromRest(*this).inverse();
}

Vec2 Trochoid::slope() const {
    return restFromPlace() * gradient;
}

/// Along a line of resting places a(t) whose places are a straight line of unit direction d: a' = P d with P
/// the derivative of the resting place by the place, and a" = -P X"[a', a']. With the slope m the elevation's
/// derivatives are Q[a', a'] and C[a', a', a'] + 3 Q[a', a"], where Q = Z" - m . X" and C = Z"' - m . X"' are
/// made of those of place X and elevation Z by the resting place.
SurfaceBend surfaceBend(const Trochoid& at) {
    const Eigen::Matrix2d restFromPlace = at.restFromPlace();
    const Vec2 slope = restFromPlace * at.gradient, x = restFromPlace.col(0), y = restFromPlace.col(1);
    const Eigen::Matrix2d q = -symmetric(at.sag[0], at.sag[1], at.sag[2]) - along(at.bend, slope);
    const Eigen::Vector4d c =
        at.sagFalls - at.bendRises.head<4>() * slope.x() - at.bendRises.tail<4>() * slope.y();
    const Vec2 qx = q * x, qy = q * y;
    const Eigen::Matrix2d cx = along(c, x), cy = along(c, y), bendX = restFromPlace * along(at.bend, x),
                          bendY = restFromPlace * along(at.bend, y);
    const double xxx = x.dot(cx * x) - 3 * qx.dot(bendX * x);
    const double xxy = x.dot(cx * y) - qy.dot(bendX * x) - 2 * qx.dot(bendX * y);
    const double xyy = y.dot(cy * x) - qx.dot(bendY * y) - 2 * qy.dot(bendX * y);
    const double yyy = y.dot(cy * y) - 3 * qy.dot(bendY * y);
    return {symmetric(x.dot(qx), x.dot(qy), y.dot(qy)), largestThirdDerivative(xxx, xxy, xyy, yyy)};
}

Trochoid findTrochoid(const std::vector<WaveLanes>& waves, double time, const Vec2& place, double reach) {
    return find<false>(waves, time, place, reach);
}

Trochoid findBentTrochoid(const std::vector<WaveLanes>& waves, double time, const Vec2& place, double reach) {
    return find<true>(waves, time, place, reach);
}

}  // namespace bullet_buoyancy
