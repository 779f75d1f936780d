// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/hydrostatics/pack_lanes.h"
#include "bullet_buoyancy/hydrostatics/wet_kernels.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

using Numbers = Lanes<double>;
using Vector = LaneVector<double>;

Numbers absolute(const Numbers& n) {
    return n < Numbers{} ? -n : n;
}
Numbers smaller(const Numbers& m, const Numbers& n) {
    return m < n ? m : n;
}
Numbers larger(const Numbers& m, const Numbers& n) {
    return m > n ? m : n;
}

Vector cross(const Vector& u, const Vector& v) {
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

struct LaneTriangles {
    Vector a, b, c, areaVector;

    LaneTriangles(const TrianglePack<double>& pack, int lane)
        : a(loadVector(pack.a, lane)),
          b(loadVector(pack.b, lane)),
          c(loadVector(pack.c, lane)),
          areaVector(loadVector(pack.areaVector, lane)) {}

    Truths<double> areWithin(const double (&size)[3]) const {
        const Truths<double> x = span(a.x, b.x, c.x) <= spread(size[0]),
                             y = span(a.y, b.y, c.y) <= spread(size[1]),
                             z = span(a.z, b.z, c.z) <= spread(size[2]);
        return x & y & z;
    }

    static Numbers span(const Numbers& a, const Numbers& b, const Numbers& c) {
        return larger(a, larger(b, c)) - smaller(a, smaller(b, c));
    }
};

/// A quadratic over triangles: its values at the corners, and its second differences along the sides opposite
/// to them.
struct OverTriangles {
    Numbers a, b, c;
    Numbers acrossA, acrossB, acrossC;

    /// `oa`, `ob`, `oc`: the corners from the quadratic's centre.
    OverTriangles(const QuadraticRows& rows, int lane, const Vector& oa, const Vector& ob, const Vector& oc) {
        const Numbers value = load(rows.value.lane + lane), half = spread(0.5);
        const Vector gradient = loadVector(rows.gradient, lane);
        Numbers bend[6];
        for (int i = 0; i < 6; ++i)
            bend[i] = load(rows.bend[i].lane + lane);
        const auto turned = [&](const Vector& o) {
            return Vector{bend[0] * o.x + bend[1] * o.y + bend[2] * o.z,
                          bend[1] * o.x + bend[3] * o.y + bend[4] * o.z,
                          bend[2] * o.x + bend[4] * o.y + bend[5] * o.z};
        };
        const Vector ta = turned(oa), tb = turned(ob), tc = turned(oc);
        a = value + oa.dot(gradient + half * ta);
        b = value + ob.dot(gradient + half * tb);
        c = value + oc.dot(gradient + half * tc);
        acrossA = (oc - ob).dot(tc - tb);
        acrossB = (oa - oc).dot(ta - tc);
        acrossC = (ob - oa).dot(tb - ta);
    }

    Numbers least() const { return smaller(a, smaller(b, c)); }
    Numbers most() const { return larger(a, larger(b, c)); }

    /// The most that it may stray from the linear function between its corners.
    Numbers excess() const {
        return spread(1.0 / 6) * larger(absolute(acrossA), larger(absolute(acrossB), absolute(acrossC)));
    }

    Numbers mean() const {
        return spread(1.0 / 3) * (a + b + c) - spread(1.0 / 24) * (acrossA + acrossB + acrossC);
    }

    /// Mean of its product with the position: by the mass matrix of quadratic with linear shape functions.
    Vector meanMoment(const LaneTriangles& t) const {
        const Numbers ofCorner = spread(1.0 / 12), ofSide = spread(1.0 / 120), sum = a + b + c;
        const Numbers twice = spread(2.0) * (acrossA + acrossB + acrossC);
        return (ofCorner * (sum + a) - ofSide * (twice - acrossA)) * t.a +
               (ofCorner * (sum + b) - ofSide * (twice - acrossB)) * t.b +
               (ofCorner * (sum + c) - ofSide * (twice - acrossC)) * t.c;
    }
};

/// Mean of the product of two of them: what each has more than linear by the rule of the sides' middles.
Numbers meanProduct(const OverTriangles& f, const OverTriangles& g) {
    const Numbers linear = (f.a + f.b + f.c) * (g.a + g.b + g.c) + f.a * g.a + f.b * g.b + f.c * g.c;
    const Numbers half = spread(0.5), eighth = spread(-1.0 / 8);
    const auto ofSide = [&](const Numbers& fAcross, const Numbers& f2, const Numbers& gAcross,
                            const Numbers& g2) {
        const Numbers fMore = eighth * fAcross, gMore = eighth * gAcross;
        return fMore * (half * g2 + gMore) + half * f2 * gMore;
    };
    const Numbers more = ofSide(f.acrossA, f.b + f.c, g.acrossA, g.b + g.c) +
                         ofSide(f.acrossB, f.c + f.a, g.acrossB, g.c + g.a) +
                         ofSide(f.acrossC, f.a + f.b, g.acrossC, g.a + g.b);
    return spread(1.0 / 12) * linear + spread(1.0 / 3) * more;
}

/// Adds to rows where triangles are wet.
struct WetSum {
    Truths<double> wet;
    int lane;

    void operator()(PackRow<double>& row, const Numbers& summand) const {
        addTo<double>(row, lane, wet ? summand : Numbers{});
    }
    void operator()(PackRow<double> (&row)[3], const Vector& summand) const {
        (*this)(row[0], summand.x);
        (*this)(row[1], summand.y);
        (*this)(row[2], summand.z);
    }
};

void addPressure(const LaneTriangles& t, const OverTriangles& depth, const OverTriangles& head,
                 const Numbers& areaUp, const WetSum& add, HeadRows& rows) {
    const Vector depthMoment = depth.meanMoment(t);
    const Vector headMoment = &depth == &head ? depthMoment : head.meanMoment(t);
    const Numbers depthSquared = meanProduct(depth, depth);
    add(rows.headNormal, head.mean() * t.areaVector);
    add(rows.headTorque, cross(headMoment, t.areaVector));
    add(rows.depth, depth.mean() * areaUp);
    add(rows.depthMoment, areaUp * depthMoment);
    add(rows.depthSquared, depthSquared * areaUp);
    add(rows.depthTimesHead, (&depth == &head ? depthSquared : meanProduct(depth, head)) * areaUp);
}

void addShadow(const LaneTriangles& t, const Numbers& areaUp, const Numbers& area, const WetSum& add,
               ShadowRows<double>& rows) {
    const Vector s = t.a + t.b + t.c;
    add(rows.area, area);
    add(rows.shadow, areaUp);
    add(rows.shadowMoment, spread(1.0 / 3) * areaUp * s);
    const Numbers factor = spread(1.0 / 12) * areaUp;
    const auto square = [&](Numbers Vector::*i, Numbers Vector::*j) {
        return factor * (s.*i * s.*j + t.a.*i * t.a.*j + t.b.*i * t.b.*j + t.c.*i * t.c.*j);
    };
    add(rows.shadowMoments2[0], square(&Vector::x, &Vector::x));
    add(rows.shadowMoments2[1], square(&Vector::x, &Vector::y));
    add(rows.shadowMoments2[2], square(&Vector::x, &Vector::z));
    add(rows.shadowMoments2[3], square(&Vector::y, &Vector::y));
    add(rows.shadowMoments2[4], square(&Vector::y, &Vector::z));
    add(rows.shadowMoments2[5], square(&Vector::z, &Vector::z));
}

template <WetRowsAsked asked>
int addWet(const TrianglePack<double>& pack, const PackWater& water, const PackSea& sea, HeadRows& rows,
           std::uint8_t* left) {
    const Vector up{spread(sea.up[0]), spread(sea.up[1]), spread(sea.up[2])};
    const Numbers none{}, one = spread(1.0), inPlan = spread(sea.isHydrostatic ? 1.0 : 0.0);
    alignas(64) double isLeft[packSize];
    for (int lane = 0; lane < packSize; lane += laneCount<double>) {
        const LaneTriangles t(pack, lane);
        const Vector centre = loadVector(water.centre, lane);
        const Vector oa = t.a - centre, ob = t.b - centre, oc = t.c - centre;
        const OverTriangles depth(water.depth, lane, oa, ob, oc);
        // d^3 <= d^2 (d^2 / D + D) / 2, whatever D: no root is needed.
        const Numbers third = load(water.error[1].lane + lane);
        const Numbers second = load(water.error[0].lane + lane) + spread(water.typicalDistance / 2) * third,
                      fourth =
                          load(water.error[2].lane + lane) + spread(1 / (2 * water.typicalDistance)) * third;
        const auto distance2 = [&](const Vector& o) {
            const Numbers along = up.dot(o);
            return o.dot(o) - inPlan * along * along;
        };
        const auto errorAt = [&](const Numbers& d2) { return d2 * (second + fourth * d2); };
        const Numbers da = distance2(oa), db = distance2(ob), dc = distance2(oc);
        const Numbers farthest = larger(da, larger(db, dc)), largestError = errorAt(farthest);
        const Numbers strayed = largestError + depth.excess();
        const Numbers area = load(pack.area.lane + lane);
        const Truths<double> notDry = (depth.most() > -strayed) & (area > none);
        const Truths<double> valid = farthest <= spread(sea.validity2),
                             exact = largestError <= spread(sea.headError), small = t.areWithin(sea.largest);
        const Truths<double> wet = notDry & valid & (exact | small) & (depth.least() >= strayed);
        store<double>(wet ? none : (notDry ? one : none), isLeft + lane);

        const WetSum add{wet, lane};
        const Numbers areaUp = up.dot(t.areaVector);
        if (sea.isHydrostatic)
            addPressure(t, depth, depth, areaUp, add, rows);
        else
            addPressure(t, depth, OverTriangles(water.head, lane, oa, ob, oc), areaUp, add, rows);
        // The error is convex: over the triangle its mean is at most that of the corners.
        const Numbers error = spread(1.0 / 3) * (errorAt(da) + errorAt(db) + errorAt(dc));
        add(rows.error, {error * absolute(t.areaVector.x), error * absolute(t.areaVector.y),
                         error * absolute(t.areaVector.z)});
        if constexpr (asked == WetRowsAsked::all) addShadow(t, areaUp, area, add, rows.shadow);
    }
    int count = 0;
    for (int triangle = 0; triangle < packSize; ++triangle) {
        left[count] = std::uint8_t(triangle);
        count += isLeft[triangle] > 0;
    }
    return count;
}

}  // namespace

extern const WetKernels wetTriangles;
const WetKernels wetTriangles = {{addWet<WetRowsAsked::pressure>, addWet<WetRowsAsked::all>}};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
