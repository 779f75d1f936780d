// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/hydrostatics/clip_kernels.h"
#include "bullet_buoyancy/hydrostatics/lane_vector.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

/// Depths smaller than its square root may be rounded to nothing, m^2.
template <typename Real>
constexpr Real smallest = Real(sizeof(Real) == sizeof(float) ? 1e-37 : 1e-300);

template <typename Real>
struct LanePlane {
    LaneVector<Real> up;
    Lanes<Real> depthOfOrigin;

    explicit LanePlane(const PackPlane& plane)
        : up{spread(Real(plane.up[0])), spread(Real(plane.up[1])), spread(Real(plane.up[2]))},
          depthOfOrigin(spread(Real(plane.depthOfOrigin))) {}

    Lanes<Real> depth(const LaneVector<Real>& point) const { return depthOfOrigin - up.dot(point); }
};

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

/// Triangles and the plane of the water, without branches. A triangle that is cut has one corner p alone on
/// its side; with its neighbours q and r the plane cuts off the shares s and t of its two sides. What is wet
/// of a triangle is the whole of it if two corners are, plus that tip if p is wet, minus it if p is dry.
template <typename Real>
struct CutTriangles {
    using Numbers = Lanes<Real>;

    LaneVector<Real> a, b, c;
    Numbers da, db, dc;       // depths
    Truths<Real> la, lb, lc;  // which corner is alone
    Truths<Real> whole;       // two corners or more are wet
    Numbers s, t;             // no tip: 0
    Numbers tipDepth;         // of p, without its sign

    CutTriangles(const TrianglePack<Real>& pack, int lane, const LanePlane<Real>& plane)
        : a(loadVector(pack.a, lane)), b(loadVector(pack.b, lane)), c(loadVector(pack.c, lane)) {
        da = plane.depth(a), db = plane.depth(b), dc = plane.depth(c);
        const Numbers none{};
        const Truths<Real> wa = da > none, wb = db > none, wc = dc > none;
        const Truths<Real> ab = wa ^ wb, bc = wb ^ wc, ca = wc ^ wa;
        la = ab & ca, lb = ab & bc, lc = bc & ca;
        whole = (wa & wb) | (wc & (wa | wb));
        const Numbers dp = la ? da : (lb ? db : (lc ? dc : none)), dq = la ? db : da, dr = lc ? db : dc;
        const Numbers toQ = dp - dq, toR = dp - dr, least = spread(smallest<Real>);
        const Numbers product = toQ * toR;  // above zero where there is a tip
        const Numbers share = dp / (product > least ? product : least);
        s = share * toR;
        t = share * toQ;
        tipDepth = dp < none ? -dp : dp;
    }

    /// Depth and depth moments: weights of the corners, times 12.
    void addPressure(const Numbers& areaUp, Numbers& depth, LaneVector<Real>& moment) const {
        const Numbers none{};
        const Numbers tip = s * t * tipDepth;  // a dry tip is taken away, and its depth is below zero
        const Numbers q = tip * s, r = tip * t, p = tip * spread(Real(4)) - q - r;
        const Numbers sum = da + db + dc;
        const Numbers wa = (whole ? sum + da : none) + (la ? p : q);
        const Numbers wb = (whole ? sum + db : none) + (lb ? p : (la ? q : r));
        const Numbers wc = (whole ? sum + dc : none) + (lc ? p : r);
        depth += areaUp * ((whole ? sum : none) + tip);
        moment.x += areaUp * (wa * a.x + wb * b.x + wc * c.x);
        moment.y += areaUp * (wa * a.y + wb * b.y + wc * c.y);
        moment.z += areaUp * (wa * a.z + wb * b.z + wc * c.z);
    }

    /// The shadow that the wet surface throws on the water, and how much of it is wet.
    void addShadow(const Numbers& areaUp, const Numbers& area, int lane, ShadowRows<Real>& rows) const {
        const Numbers none{}, one = spread(Real(1)), third = spread(Real(1) / 3),
                              twelfth = spread(Real(1) / 12);
        const LaneVector<Real> p = select<Real>(la, a, select<Real>(lb, b, c));
        const LaneVector<Real> q = p + s * (select<Real>(la, b, a) - p),
                               r = p + t * (select<Real>(lc, b, c) - p);
        const Numbers allOfIt = whole ? one : none, tip = whole ? -(s * t) : s * t;
        addTo<Real>(rows.area, lane, area * (allOfIt + tip));
        addTo<Real>(rows.shadow, lane, areaUp * (allOfIt + tip));
        const LaneVector<Real> mean = third * allOfIt * (a + b + c) + third * tip * (p + q + r);
        addTo<Real>(rows.shadowMoment[0], lane, areaUp * mean.x);
        addTo<Real>(rows.shadowMoment[1], lane, areaUp * mean.y);
        addTo<Real>(rows.shadowMoment[2], lane, areaUp * mean.z);
        Numbers second[6] = {};
        addSecondMoments<Real>(twelfth * allOfIt, a, b, c, second);
        addSecondMoments<Real>(twelfth * tip, p, q, r, second);
        for (int row = 0; row < 6; ++row)
            addTo<Real>(rows.shadowMoments2[row], lane, areaUp * second[row]);
    }
};

template <typename Real, WetRowsAsked asked>
void clip(const TrianglePack<Real>* packs, const std::uint32_t* which, int count, const PackPlane& plane,
          WetRows<Real>& rows) {
    const LanePlane<Real> water(plane);
    for (int lane = 0; lane < packSize; lane += laneCount<Real>) {
        Lanes<Real> depth{};
        LaneVector<Real> moment{};
        for (int i = 0; i < count; ++i) {
            const TrianglePack<Real>& pack = packs[which ? which[i] : std::uint32_t(i)];
            const Lanes<Real> areaUp = water.up.dot(loadVector(pack.areaVector, lane));
            const CutTriangles<Real> triangles(pack, lane, water);
            triangles.addPressure(areaUp, depth, moment);
            if constexpr (asked == WetRowsAsked::all)
                triangles.addShadow(areaUp, load(pack.area.lane + lane), lane, rows.shadow);
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
    const LanePlane<Real> water(plane);
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
