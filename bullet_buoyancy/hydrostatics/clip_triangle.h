#pragma once

#include <algorithm>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// A point of a surface and its depth: above zero under water, m.
struct DepthPoint {
    Vec3 position;
    double depth;
};

/// The same in waves, where pressure need not grow with depth alone.
struct HeadPoint {
    Vec3 position;
    double depth;
    double head;  ///< pressure over density and gravity, m
};

inline double headOf(const DepthPoint& point) {
    return point.depth;
}
inline double headOf(const HeadPoint& point) {
    return point.head;
}

/// Whether the head may be another than the depth.
template <typename Point>
inline constexpr bool headVaries = false;
template <>
inline constexpr bool headVaries<HeadPoint> = true;

/// Where the surface of the water cuts the edge between a wet and a dry point; depth is linear along it.
inline DepthPoint waterlinePoint(const DepthPoint& wet, const DepthPoint& dry) {
    const double fraction = wet.depth / (wet.depth - dry.depth);
    return {wet.position + fraction * (dry.position - wet.position), 0};
}

inline HeadPoint waterlinePoint(const HeadPoint& wet, const HeadPoint& dry) {
    const double fraction = wet.depth / (wet.depth - dry.depth);
    return {wet.position + fraction * (dry.position - wet.position), 0, 0};
}

/// Share of a triangle's area that lies under water, from the depths alone.
inline double wetShare(double a, double b, double c) {
    const double least = std::min({a, b, c}), most = std::max({a, b, c}), middle = a + b + c - least - most;
    if (least >= 0) return 1;
    if (most <= 0) return 0;
    if (middle <= 0) return most * most / ((most - middle) * (most - least));
    return 1 - least * least / ((middle - least) * (most - least));
}

/// Calls `visit(p, q, r)` for the triangles, none to two, which make up the part of triangle abc that lies
/// under water, with the winding of abc; where they are cut, the waterline is the edge from `r` to `p` of the
/// last of them.
template <typename Point, typename Visit>
void visitWetPart(const Point& a, const Point& b, const Point& c, const Visit& visit) {
    const int wet = (a.depth > 0) + (b.depth > 0) + (c.depth > 0);
    if (wet == 0) return;
    if (wet == 3) return visit(a, b, c);

    const auto oneWet = [&](const Point& tip, const Point& next, const Point& last) {
        visit(waterlinePoint(tip, last), tip, waterlinePoint(tip, next));
    };
    const auto oneDry = [&](const Point& tip, const Point& next, const Point& last) {
        const Point leaving = waterlinePoint(last, tip), entering = waterlinePoint(next, tip);
        visit(entering, next, last);
        visit(entering, last, leaving);
    };
    if (wet == 1) {
        if (a.depth > 0) return oneWet(a, b, c);
        if (b.depth > 0) return oneWet(b, c, a);
        return oneWet(c, a, b);
    }
    if (!(a.depth > 0)) return oneDry(a, b, c);
    if (!(b.depth > 0)) return oneDry(b, c, a);
    return oneDry(c, a, b);
}

}  // namespace bullet_buoyancy
