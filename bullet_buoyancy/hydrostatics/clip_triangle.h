#pragma once

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// A point of a surface and its depth: above zero under water, m.
struct DepthPoint {
    Vec3 position;
    double depth;
};

/// Where the surface of the water cuts the edge between a wet and a dry point; depth is linear along it.
inline DepthPoint waterlinePoint(const DepthPoint& wet, const DepthPoint& dry) {
    const double fraction = wet.depth / (wet.depth - dry.depth);
    return {wet.position + fraction * (dry.position - wet.position), 0};
}

/// Calls `visit(p, q, r)` for the triangles, none to two, which make up the part of triangle abc that lies
/// under water, with the winding of abc; where they are cut, the waterline is the edge from `r` to `p` of the
/// last of them.
template <typename Visit>
void visitWetPart(const DepthPoint& a, const DepthPoint& b, const DepthPoint& c, const Visit& visit) {
    const int wet = (a.depth > 0) + (b.depth > 0) + (c.depth > 0);
    if (wet == 0) return;
    if (wet == 3) return visit(a, b, c);

    const auto oneWet = [&](const DepthPoint& tip, const DepthPoint& next, const DepthPoint& last) {
        visit(waterlinePoint(tip, last), tip, waterlinePoint(tip, next));
    };
    const auto oneDry = [&](const DepthPoint& tip, const DepthPoint& next, const DepthPoint& last) {
        const DepthPoint leaving = waterlinePoint(last, tip), entering = waterlinePoint(next, tip);
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
