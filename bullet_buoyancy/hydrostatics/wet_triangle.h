#pragma once

#include <Eigen/Geometry>

#include "bullet_buoyancy/hydrostatics/clip_triangle.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Integrals of f r and f g over a triangle of unit area: for linear functions f and g the latter is
/// ((sum f)(sum g) + sum f_i g_i) / 12.
template <typename Point>
inline Vec3 meanMoment(const Point& a, const Point& b, const Point& c, double fa, double fb, double fc) {
    return ((fa + fb + fc) * (a.position + b.position + c.position) + fa * a.position + fb * b.position +
            fc * c.position) /
           12;
}

/// A wholly wet triangle. Volumes by the divergence theorem with fields that vanish at depth 0, so that the
/// waterplane adds nothing.
template <typename Point>
void addPressure(const Point& a, const Point& b, const Point& c, const Vec3& up, WetIntegrals& integrals) {
    const Vec3 areaVector = (b.position - a.position).cross(c.position - a.position) / 2;
    const double headA = headOf(a), headB = headOf(b), headC = headOf(c);
    const double sumHead = headA + headB + headC, sumDepth = a.depth + b.depth + c.depth;
    const Vec3 depthMoment = meanMoment(a, b, c, a.depth, b.depth, c.depth);
    Vec3 headMoment = depthMoment;
    if constexpr (headVaries<Point>) headMoment = meanMoment(a, b, c, headA, headB, headC);
    const double depthSquared =
        (sumDepth * sumDepth + a.depth * a.depth + b.depth * b.depth + c.depth * c.depth) / 12;
    const double depthTimesHead =
        (sumDepth * sumHead + a.depth * headA + b.depth * headB + c.depth * headC) / 12;
    const double areaUp = areaVector.dot(up);

    integrals.headNormal += sumHead / 3 * areaVector;
    integrals.headTorque += headMoment.cross(areaVector);
    integrals.volume -= sumDepth / 3 * areaUp;
    integrals.volumeMoment -= areaUp * (depthMoment + depthSquared / 2 * up);
    integrals.headVolume -= depthTimesHead / 2 * areaUp;
}

/// The shadow that a wet triangle throws straight up on the water's surface, negative where it faces up: over
/// a closed hull they sum to the waterplane.
template <typename Point>
void addShadow(const Point& a, const Point& b, const Point& c, const Vec3& up, Waterplane& waterplane) {
    const double area = -(b.position - a.position).cross(c.position - a.position).dot(up) / 2;
    const Vec3 pa = a.position + a.depth * up, pb = b.position + b.depth * up, pc = c.position + c.depth * up;
    const Vec3 sum = pa + pb + pc;
    waterplane.area += area;
    waterplane.firstMoment += area / 3 * sum;
    waterplane.secondMoment +=
        area / 12 * (sum * sum.transpose() + pa * pa.transpose() + pb * pb.transpose() + pc * pc.transpose());
}

/// A wholly wet triangle, with what the query asks for.
template <typename Point>
void addWetTriangle(const Point& a, const Point& b, const Point& c, const Vec3& up,
                    const HydrostaticQuery& query, WetIntegrals& integrals) {
    addPressure(a, b, c, up, integrals);
    if (query.wettedArea)
        integrals.wettedArea += (b.position - a.position).cross(c.position - a.position).norm() / 2;
    if (query.needsWaterplane()) addShadow(a, b, c, up, integrals.waterplane);
}

}  // namespace bullet_buoyancy
