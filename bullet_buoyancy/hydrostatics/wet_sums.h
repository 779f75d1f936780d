#pragma once

#include "bullet_buoyancy/hydrostatics/child_moments.h"
#include "bullet_buoyancy/hydrostatics/pack_rows.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/hydrostatics/wet_kernels.h"

namespace bullet_buoyancy {

/// Integrals over the wet surface about the packed mesh's origin, as those of `HeadRows`.
struct WetSums {
    Vec3 headNormal = Vec3::Zero(), headTorque = Vec3::Zero();
    double depth = 0;
    Vec3 depthMoment = Vec3::Zero();
    double depthSquared = 0, depthTimesHead = 0;
    Vec3 error = Vec3::Zero();
    double shadow = 0;
    Vec3 shadowMoment = Vec3::Zero();
    Mat3 shadowMoments2 = Mat3::Zero();
    double area = 0;

    void add(const HeadRows& rows) {
        headNormal += sumOf(rows.headNormal);
        headTorque += sumOf(rows.headTorque);
        depth += sumOf(rows.depth);
        depthMoment += sumOf(rows.depthMoment);
        depthSquared += sumOf(rows.depthSquared);
        depthTimesHead += sumOf(rows.depthTimesHead);
        error += sumOf(rows.error);
    }

    void add(const ShadowRows<double>& rows) {
        shadow += sumOf(rows.shadow);
        shadowMoment += sumOf(rows.shadowMoment);
        shadowMoments2 += symmetricSumOf(rows.shadowMoments2);
        area += sumOf(rows.area);
    }

    /// A wet child. Of products of depth with depth or head, that of what both bend is left out.
    void add(const WeightedMoments& ofDepth, const WeightedMoments& ofHead, const Vec3& up) {
        const double byBend = up.dot(ofDepth.byBend);
        const auto timesDepth = [&](const WeightedMoments& f) {
            return ofDepth.atOrigin * up.dot(f.normal) + ofDepth.gradient.dot(f.first * up) +
                   f.atMiddle * byBend;
        };
        headNormal += ofHead.normal;
        headTorque += ofHead.torque();
        depth += up.dot(ofDepth.normal);
        depthMoment += ofDepth.first * up;
        depthSquared += timesDepth(ofDepth);
        depthTimesHead += timesDepth(ofHead);
    }

    void addShadow(const ChildMoments& moments, const Vec3& up) {
        shadow += up.dot(moments.normal);
        shadowMoment += moments.first * up;
        for (Eigen::Index k = 0; k < 3; ++k)
            shadowMoments2 += up[k] * moments.second[std::size_t(k)];
    }

    /// See `addPressure` of a triangle.
    void addTo(WetIntegrals& integrals, const Vec3& origin, const Vec3& up) const {
        integrals.headNormal += headNormal;
        integrals.headTorque += headTorque + origin.cross(headNormal);
        integrals.volume -= depth;
        integrals.volumeMoment -= depthMoment + depthSquared / 2 * up + depth * origin;
        integrals.headVolume -= depthTimesHead / 2;
        integrals.error += error;
    }

    /// A point x throws its shadow on x + d up.
    void addTo(Waterplane& waterplane, const Vec3& origin, const Vec3& up) const {
        const Vec3 first = shadowMoment + depth * up;
        const Mat3 cross = depthMoment * up.transpose() + first * origin.transpose();
        waterplane.area -= shadow;
        waterplane.firstMoment -= first + shadow * origin;
        waterplane.secondMoment -= shadowMoments2 + cross + cross.transpose() +
                                   depthSquared * up * up.transpose() + shadow * origin * origin.transpose();
    }
};

}  // namespace bullet_buoyancy
