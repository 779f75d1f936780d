#pragma once

#include "bullet_buoyancy/hydrostatics/clip_kernels.h"
#include "bullet_buoyancy/hydrostatics/pack_lanes.h"

// Only kernels include this: see core/lanes.h.
namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

/// Depths smaller than its square root may be rounded to nothing, m^2.
template <typename Real>
inline constexpr Real smallest = Real(sizeof(Real) == sizeof(float) ? 1e-37 : 1e-300);

template <typename Real>
struct LanePlane {
    LaneVector<Real> up;
    Lanes<Real> depthOfOrigin;

    Lanes<Real> depth(const LaneVector<Real>& point) const { return depthOfOrigin - up.dot(point); }
};

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

    CutTriangles(const LaneVector<Real>& cornerA, const LaneVector<Real>& cornerB,
                 const LaneVector<Real>& cornerC, const LanePlane<Real>& plane)
        : a(cornerA), b(cornerB), c(cornerC) {
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
};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
