// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/hydrostatics/clip_kernels.h"
#include "bullet_buoyancy/hydrostatics/cut_triangles.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

template <typename Real>
LanePlane<Real> inAllLanes(const PackPlane& plane) {
    return {{spread(Real(plane.up[0])), spread(Real(plane.up[1])), spread(Real(plane.up[2]))},
            spread(Real(plane.depthOfOrigin))};
}

/// Adds the integrals of x_i x_j over triangles, times `factor` / 12.
template <typename Real>
void addSecondMoments(const Lanes<Real>& factor, const LaneVector<Real>& a, const LaneVector<Real>& b,
                      const LaneVector<Real>& c, Lanes<Real> (&sums)[6]) {
    const LaneVector<Real> s = a + b + c;
    sums[0] += factor * (s.x * s.x + a.x * a.x + b.x * b.x + c.x * c.x);
    sums[1] += factor * (s.x * s.y + a.x * a.y + b.x * b.y + c.x * c.y);
    sums[2] += factor * (s.x * s.z + a.x * a.z + b.x * b.z + c.x * c.z);
    sums[3] += factor * (s.y * s.y + a.y * a.y + b.y * b.y + c.y * c.y);
    sums[4] += factor * (s.y * s.z + a.y * a.z + b.y * b.z + c.y * c.z);
    sums[5] += factor * (s.z * s.z + a.z * a.z + b.z * b.z + c.z * c.z);
}

/// The shadow that the wet surface throws on the water, and how much of it is wet.
template <typename Real>
void addShadow(const CutTriangles<Real>& triangles, const Lanes<Real>& areaUp, const Lanes<Real>& area,
               int lane, ShadowRows<Real>& rows) {
    const auto& [a, b, c, da, db, dc, la, lb, lc, whole, s, t, tipDepth] = triangles;
    const Lanes<Real> none{}, one = spread(Real(1)), third = spread(Real(1) / 3),
                              twelfth = spread(Real(1) / 12);
    const LaneVector<Real> p = select<Real>(la, a, select<Real>(lb, b, c));
    const LaneVector<Real> q = p + s * (select<Real>(la, b, a) - p), r = p + t * (select<Real>(lc, b, c) - p);
    const Lanes<Real> allOfIt = whole ? one : none, tip = whole ? -(s * t) : s * t;
    addTo<Real>(rows.area, lane, area * (allOfIt + tip));
    addTo<Real>(rows.shadow, lane, areaUp * (allOfIt + tip));
    const LaneVector<Real> mean = third * allOfIt * (a + b + c) + third * tip * (p + q + r);
    addTo<Real>(rows.shadowMoment[0], lane, areaUp * mean.x);
    addTo<Real>(rows.shadowMoment[1], lane, areaUp * mean.y);
    addTo<Real>(rows.shadowMoment[2], lane, areaUp * mean.z);
    Lanes<Real> second[6] = {};
    addSecondMoments<Real>(twelfth * allOfIt, a, b, c, second);
    addSecondMoments<Real>(twelfth * tip, p, q, r, second);
    for (int row = 0; row < 6; ++row)
        addTo<Real>(rows.shadowMoments2[row], lane, areaUp * second[row]);
}

template <typename Real, WetRowsAsked asked>
void clip(const TrianglePack<Real>* packs, const std::uint32_t* which, int count, const PackPlane& plane,
          WetRows<Real>& rows) {
    const LanePlane<Real> water = inAllLanes<Real>(plane);
    for (int lane = 0; lane < packSize; lane += laneCount<Real>) {
        Lanes<Real> depth{};
        LaneVector<Real> moment{};
        for (int i = 0; i < count; ++i) {
            const TrianglePack<Real>& pack = packs[which ? which[i] : std::uint32_t(i)];
            const Lanes<Real> areaUp = water.up.dot(loadVector(pack.areaVector, lane));
            const CutTriangles<Real> triangles(loadVector(pack.a, lane), loadVector(pack.b, lane),
                                               loadVector(pack.c, lane), water);
            triangles.addPressure(areaUp, depth, moment);
            if constexpr (asked == WetRowsAsked::all)
                addShadow<Real>(triangles, areaUp, load(pack.area.lane + lane), lane, rows.shadow);
        }
        addTo<Real>(rows.pressure.depth, lane, spread(Real(1) / 3) * depth);
        const Lanes<Real> twelfth = spread(Real(1) / 12);
        addTo<Real>(rows.pressure.depthMoment[0], lane, twelfth * moment.x);
        addTo<Real>(rows.pressure.depthMoment[1], lane, twelfth * moment.y);
        addTo<Real>(rows.pressure.depthMoment[2], lane, twelfth * moment.z);
    }
}

/// Moments of children with the upward part of the normal.
template <typename Real>
struct ShadowMoments {
    Lanes<Real> zeroth;
    LaneVector<Real> first;
    Lanes<Real> second[6];

    ShadowMoments(const MomentRows<Real>& moments, int lane, const LaneVector<Real>& up)
        : zeroth(up.dot(loadVector(moments.normal, lane))),
          first{up.dot(loadVector(moments.first[0], lane)), up.dot(loadVector(moments.first[1], lane)),
                up.dot(loadVector(moments.first[2], lane))} {
        for (int row = 0; row < 6; ++row)
            second[row] = up.dot(loadVector(moments.second[row], lane));
    }

    /// Of the position's product with its part along `up`.
    LaneVector<Real> secondAlong(const LaneVector<Real>& up) const {
        return {up.x * second[0] + up.y * second[1] + up.z * second[2],
                up.x * second[1] + up.y * second[3] + up.z * second[4],
                up.x * second[2] + up.y * second[4] + up.z * second[5]};
    }
};

template <typename Real, WetRowsAsked asked>
void addWetChildren(const MomentRows<Real>& moments, int lane, const LanePlane<Real>& plane,
                    const Truths<Real>& wet, WetRows<Real>& rows) {
    const ShadowMoments<Real> shadow(moments, lane, plane.up);
    const Lanes<Real> none{}, h = plane.depthOfOrigin;
    const auto add = [&](PackRow<Real>& row, const Lanes<Real>& summand) {
        addTo<Real>(row, lane, wet ? summand : none);
    };
    add(rows.pressure.depth, h * shadow.zeroth - plane.up.dot(shadow.first));
    const LaneVector<Real> moment = h * shadow.first - shadow.secondAlong(plane.up);
    add(rows.pressure.depthMoment[0], moment.x);
    add(rows.pressure.depthMoment[1], moment.y);
    add(rows.pressure.depthMoment[2], moment.z);
    if constexpr (asked == WetRowsAsked::all) {
        add(rows.shadow.shadow, shadow.zeroth);
        add(rows.shadow.shadowMoment[0], shadow.first.x);
        add(rows.shadow.shadowMoment[1], shadow.first.y);
        add(rows.shadow.shadowMoment[2], shadow.first.z);
        for (int row = 0; row < 6; ++row)
            add(rows.shadow.shadowMoments2[row], shadow.second[row]);
        add(rows.shadow.area, load(moments.area.lane + lane));
    }
}

template <typename Real>
LaneVector<Real> absolute(const LaneVector<Real>& v) {
    const Lanes<Real> none{};
    return {v.x < none ? -v.x : v.x, v.y < none ? -v.y : v.y, v.z < none ? -v.z : v.z};
}

template <typename Real, WetRowsAsked asked>
int open(const Cluster<Real>& cluster, const PackPlane& plane, WetRows<Real>& rows, std::uint8_t* cut) {
    const LanePlane<Real> water = inAllLanes<Real>(plane);
    const LaneVector<Real> reach = absolute<Real>(water.up);
    const Lanes<Real> none{}, one = spread(Real(1));
    alignas(64) Real isCut[packSize];
    for (int lane = 0; lane < packSize; lane += laneCount<Real>) {
        const Lanes<Real> depth = water.depth(loadVector(cluster.centre, lane));
        const Lanes<Real> half = reach.dot(loadVector(cluster.halfExtents, lane));
        const Truths<Real> wet = depth - half > none;
        addWetChildren<Real, asked>(cluster.moments, lane, water, wet, rows);
        store<Real>(((depth - half <= none) & (depth + half > none)) ? one : none, isCut + lane);
    }
    int count = 0;
    for (int child = 0; child < packSize; ++child) {
        cut[count] = std::uint8_t(child);
        count += isCut[child] > 0;
    }
    return count;
}

/// Always in the same order, whatever the width of the register.
template <typename Real>
double sumOf(const PackRow<Real>& row) {
    Real eight[8], four[4];
    for (int i = 0; i < 8; ++i)
        eight[i] = row.lane[i] + row.lane[i + 8];
    for (int i = 0; i < 4; ++i)
        four[i] = eight[i] + eight[i + 4];
    return (double(four[0]) + double(four[2])) + (double(four[1]) + double(four[3]));
}

template <typename Real>
PressureSums sum(const PressureRows<Real>& rows) {
    return {sumOf(rows.depth),
            {sumOf(rows.depthMoment[0]), sumOf(rows.depthMoment[1]), sumOf(rows.depthMoment[2])}};
}

template <typename Real>
void clear(PackRow<Real>& row) {
    for (int lane = 0; lane < packSize; lane += laneCount<Real>)
        store<Real>(Lanes<Real>{}, row.lane + lane);
}

template <typename Real>
PressureSums press(const TrianglePack<Real>* packs, int count, const PackPlane& plane) {
    WetRows<Real> rows;
    clear(rows.pressure.depth);
    for (PackRow<Real>& row : rows.pressure.depthMoment)
        clear(row);
    clip<Real, WetRowsAsked::pressure>(packs, nullptr, count, plane, rows);
    return sum(rows.pressure);
}

}  // namespace

extern const ClipKernels<float> clipSingle;
extern const ClipKernels<double> clipFull;

const ClipKernels<float> clipSingle = {{clip<float, WetRowsAsked::pressure>, clip<float, WetRowsAsked::all>},
                                       {open<float, WetRowsAsked::pressure>, open<float, WetRowsAsked::all>},
                                       press<float>,
                                       sum<float>};
const ClipKernels<double> clipFull = {{clip<double, WetRowsAsked::pressure>, clip<double, WetRowsAsked::all>},
                                      {open<double, WetRowsAsked::pressure>, open<double, WetRowsAsked::all>},
                                      press<double>,
                                      sum<double>};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
