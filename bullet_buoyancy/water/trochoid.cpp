#include "bullet_buoyancy/water/trochoid.h"

#include "bullet_buoyancy/water/third_derivative.h"
#include "bullet_buoyancy/water/wave_kernels.h"

namespace bullet_buoyancy {

namespace {

/// From here on a particle is near enough to its place, m: rounding may keep it from coming nearer.
constexpr double placeTolerance = 1e-10;

/// Seas at a steepness of 0.99 need no more than some twenty.
constexpr int mostLooks = 100;

// Symmetric matrices have the entries xx, xy, yy, and symmetric forms of three vectors xxx, xxy, xyy, yyy.
using Form = Vec3;
using CubicForm = Eigen::Vector4d;

double determinant(const Form& m) {
    return m[0] * m[2] - m[1] * m[1];
}

Vec2 times(const Form& m, const Vec2& v) {
    return {m[0] * v.x() + m[1] * v.y(), m[1] * v.x() + m[2] * v.y()};
}

Form inverse(const Form& m) {
    return Form(m[2], -m[1], m[0]) / determinant(m);
}

/// With one of the vectors put in: the form of the other two.
inline Form along(const CubicForm& cubic, const Vec2& vector) {
    return cubic.head<3>() * vector.x() + cubic.tail<3>() * vector.y();
}

Form placeFromRest(const Trochoid& at) {
    return {1 - at.squeeze[0], -at.squeeze[1], 1 - at.squeeze[2]};
}

/// Newton's step.
Vec2 firstOrderStep(const Trochoid& at) {
    return -times(inverse(placeFromRest(at)), at.shift);
}

/// Halley's step: as Newton's, but with the derivative in the middle of Newton's step. Falls back to that
/// where the curvature is too strong to be extrapolated.
inline Vec2 secondOrderStep(const Trochoid& at) {
    const Vec2 newton = firstOrderStep(at);
    const Form derivative = placeFromRest(at), inMiddle = derivative + along(at.bend, newton / 2);
    const bool tame = inMiddle[0] + inMiddle[2] > 0 && determinant(inMiddle) > 0.25 * determinant(derivative);
    return tame ? Vec2(-times(inverse(inMiddle), at.shift)) : newton;
}

/// The particle that rests `step` farther on, and has arrived at its place.
inline Trochoid moved(Trochoid at, const Vec2& step) {
    const Vec2 slopeFalls = times(at.sag, step);
    at.rest += step;
    at.shift.setZero();
    at.elevation += step.dot(at.gradient - slopeFalls / 2);
    at.gradient -= slopeFalls;
    at.squeeze -= along(at.bend, step);
    at.sag -= along(at.sagFalls, step);
    at.bend += at.bendRises.head<4>() * step.x() + at.bendRises.tail<4>() * step.y();
    return at;
}

/// The particle that rests at `rest`, seen from `place`; with its third derivatives or with zeros for them.
template <bool withThird>
Trochoid trochoidAt(const WavesAtTime& waves, const Vec2& rest, const Vec2& place) {
    double sums[24];
    (withThird ? waveKernels().bentTrochoid : waveKernels().trochoid)(waves, rest.x(), rest.y(), sums);
    const auto& [x, y, z, dx, dy, sagXX, sagXY, sagYY, xx, xy, yy, xxx, xxy, xyy, yyy, fallsXXX, fallsXXY,
                 fallsXYY, fallsYYY, xxxx, xxxy, xxyy, xyyy, yyyy] = sums;
    Trochoid result;
    result.rest = rest;
    result.shift = rest - Vec2(x, y) - place;
    result.elevation = z;
    result.gradient = {dx, dy};
    result.sag = {sagXX, sagXY, sagYY};
    result.squeeze = {xx, xy, yy};
    result.bend = {xxx, xxy, xyy, yyy};
    if constexpr (withThird) {
        result.sagFalls = {fallsXXX, fallsXXY, fallsXYY, fallsYYY};
        result.bendRises << xxxx, xxxy, xxyy, xyyy, yyyy;
    }
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

Vec2 Trochoid::slope() const {
    return times(inverse(placeFromRest(*this)), gradient);
}

/// Along a line of resting places a(t) whose places are a straight line of unit direction d: a' = P d with P
/// the derivative of the resting place by the place, and a" = -P X"[a', a']. With the slope m the elevation's
/// derivatives are Q[a', a'] and C[a', a', a'] + 3 Q[a', a"], where Q = Z" - m . X" and C = Z"' - m . X"' are
/// made of those of place X and elevation Z by the resting place.
SurfaceBend surfaceBend(const Trochoid& at) {
    const Form restFromPlace = inverse(placeFromRest(at));
    const Vec2 slope = times(restFromPlace, at.gradient);
    const Vec2 x = restFromPlace.head<2>(), y = restFromPlace.tail<2>();
    const Form q = -at.sag - along(at.bend, slope);
    const CubicForm c = at.sagFalls - at.bendRises.head<4>() * slope.x() - at.bendRises.tail<4>() * slope.y();
    const Vec2 qx = times(q, x), qy = times(q, y);
    const Form cx = along(c, x), cy = along(c, y), bendX = along(at.bend, x), bendY = along(at.bend, y);
    const Vec2 bendXX = times(restFromPlace, times(bendX, x)), bendXY = times(restFromPlace, times(bendX, y)),
               bendYY = times(restFromPlace, times(bendY, y));
    const double xxx = x.dot(times(cx, x)) - 3 * qx.dot(bendXX);
    const double xxy = x.dot(times(cx, y)) - qy.dot(bendXX) - 2 * qx.dot(bendXY);
    const double xyy = y.dot(times(cy, x)) - qx.dot(bendYY) - 2 * qy.dot(bendXY);
    const double yyy = y.dot(times(cy, y)) - 3 * qy.dot(bendYY);
    return {slope, {x.dot(qx), x.dot(qy), y.dot(qy)}, largestThirdDerivative(xxx, xxy, xyy, yyy)};
}

Trochoid findTrochoid(const WavesAtTime& waves, const Vec2& place, double reach) {
    return find<false>(waves, place, reach);
}

Trochoid findBentTrochoid(const WavesAtTime& waves, const Vec2& place, double reach) {
    return find<true>(waves, place, reach);
}

}  // namespace bullet_buoyancy
