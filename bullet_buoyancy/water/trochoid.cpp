#include "bullet_buoyancy/water/trochoid.h"

#include <Eigen/LU>

#include "bullet_buoyancy/water/third_derivative.h"
#include "bullet_buoyancy/water/wave_kernels.h"

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
Trochoid trochoidAt(const WavesAtTime& waves, const Vec2& rest, const Vec2& place) {
    double sums[24] = {};
    (withThird ? waveKernels().bentTrochoid : waveKernels().trochoid)(waves, rest.x(), rest.y(), sums);
    Trochoid result;
    result.rest = rest;
    result.shift = rest - Vec2(sums[0], sums[1]) - place;
    result.elevation = sums[2];
    result.gradient = {sums[3], sums[4]};
    result.sag = {sums[5], sums[6], sums[7]};
    result.squeeze = {sums[8], sums[9], sums[10]};
    result.bend = {sums[11], sums[12], sums[13], sums[14]};
    result.sagFalls = {sums[15], sums[16], sums[17], sums[18]};
    result.bendRises << sums[19], sums[20], sums[21], sums[22], sums[23];
    return result;
}

/// The last look at least has third derivatives if they are wanted: the first one, which begins far off, has
/// none.
template <bool withThird>
Trochoid find(const WavesAtTime& waves, const Vec2& place, double reach) {
    const double near = placeTolerance + 1e-15 * place.norm();
    Trochoid best = trochoidAt<false>(waves, place, place);
    Vec2 step = secondOrderStep(best);
    bool fresh = true, complete = !withThird;
    for (int look = 1; look < mostLooks; ++look) {
        const bool arrived = step.squaredNorm() <= reach * reach || best.shift.squaredNorm() <= near * near;
        if (fresh && complete && arrived) break;
        const Trochoid next = trochoidAt<withThird>(waves, best.rest + step, place);
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

Trochoid findTrochoid(const WavesAtTime& waves, const Vec2& place, double reach) {
    return find<false>(waves, place, reach);
}

Trochoid findBentTrochoid(const WavesAtTime& waves, const Vec2& place, double reach) {
    return find<true>(waves, place, reach);
}

}  // namespace bullet_buoyancy
