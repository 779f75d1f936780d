#include "bullet_buoyancy/hydrostatics/solid_in_waves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/quadrature.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_sections.h"
#include "bullet_buoyancy/hydrostatics/tangent_water.h"

namespace bullet_buoyancy {

namespace {

constexpr double negligible = 1.0 / 16;  // of the error allowed

double largestRadius(const ProfilePiece& piece) {
    double radius2 = std::max(piece.radiusSquared(piece.begin), piece.radiusSquared(piece.end));
    const double widest = piece.c2 < 0 ? -piece.c1 / (2 * piece.c2) : piece.begin;
    if (piece.begin < widest && widest < piece.end) radius2 = std::max(radius2, piece.radiusSquared(widest));
    return std::sqrt(std::max(0.0, radius2));
}

/// The middle of the axis, and how far the surface is from it at most.
Sphere sphereAround(const SolidOfRevolution& solid) {
    const double begin = solid.profile.front().begin, end = solid.profile.back().end;
    double radius = 0;
    for (const ProfilePiece& piece : solid.profile)
        radius = std::max(radius, largestRadius(piece));
    return {solid.origin + (begin + end) / 2 * solid.axis, std::hypot((end - begin) / 2, radius)};
}

double wettedAreaIn(const SolidOfRevolution& solid, WaterPlane plane, double raised) {
    plane.heightOfWater += raised;
    HydrostaticQuery query;
    query.wettedArea = true;
    WetIntegrals integrals;
    addSolid(solid, plane, query, integrals);
    return integrals.wettedArea;
}

/// Where the surface strays from its tangent plane: pieces of the solid that the plane leaves wet.
class StrayingWater {
public:
    StrayingWater(const SolidOfRevolution& solid, const WaterPatch& water, const TangentWater& tangent,
                  WetIntegrals& integrals)
        : m_solid(solid),
          m_water(water),
          m_tangent(tangent),
          m_view(axisInWater(solid, tangent.plane)),
          m_sideways(m_view.axis.cross(m_view.rising)),
          m_integrals(integrals) {}

    void add() {
        for (const ProfilePiece& piece : m_solid.profile)
            addPiece(piece);
        const ProfilePiece &first = m_solid.profile.front(), &last = m_solid.profile.back();
        addDisc(first.begin, std::sqrt(std::max(0.0, first.radiusSquared(first.begin))), -1);
        addDisc(last.end, std::sqrt(std::max(0.0, last.radiusSquared(last.end))), 1);
    }

private:
    void addElement(const Vec3& position, const Vec3& areaVector) {
        const WaterExpansion& water = m_water.near(position);
        const double head = m_tangent.head(position), depth = m_tangent.depth(position);
        const double straysHead = water.headAt(position) - head,
                     straysDepth = water.depthAt(position) - depth;
        const double areaUp = areaVector.dot(m_water.upInBody());
        constexpr double quadrature = 1e-3;  // relative error, generously
        m_integrals.headNormal += straysHead * areaVector;
        m_integrals.headTorque += straysHead * position.cross(areaVector);
        m_integrals.volume -= straysDepth * areaUp;
        m_integrals.volumeMoment -=
            areaUp * (straysDepth * position + straysDepth * (depth + straysDepth / 2) * m_water.upInBody());
        m_integrals.headVolume -= areaUp / 2 * ((depth + straysDepth) * (head + straysHead) - depth * head);
        m_integrals.error +=
            (m_water.errorAt(water, position) + quadrature * std::abs(straysHead)) * areaVector.cwiseAbs();
    }

    void addPiece(const ProfilePiece& piece) {
        const std::array<double, 4> ends = stretchEnds(piece, m_view);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const double length = ends[i + 1] - ends[i], middle = (ends[i] + ends[i + 1]) / 2;
            if (!(length > 0) || m_view.depth(middle) <= -reach(piece, middle)) continue;
            const double cells = (length * m_view.axis).cwiseAbs().cwiseQuotient(m_water.cell()).maxCoeff();
            const int parts = m_water.cellCount() > 1 ? std::max(1, int(std::ceil(cells))) : 1;
            for (int part = 0; part < parts; ++part)
                addStretch(piece, ends[i] + part * length / parts, ends[i] + (part + 1) * length / parts);
        }
    }

    double reach(const ProfilePiece& piece, double x) const {
        return m_view.upAcross * std::sqrt(std::max(0.0, piece.radiusSquared(x)));
    }

    void addStretch(const ProfilePiece& piece, double begin, double end) {
        static const SineQuadrature<8> alongAxis;
        alongAxis.over(begin, end, [&](double x, double weight) {
            const double radius = std::sqrt(std::max(0.0, piece.radiusSquared(x)));
            const double radiusTimesSlope = piece.c1 / 2 + x * piece.c2;
            const Vec3 centre = m_view.origin + x * m_view.axis;
            roundWetArc(m_view.depth(x), reach(piece, x), [&](double angle, double angleWeight) {
                const Vec3 outward = std::cos(angle) * m_view.rising + std::sin(angle) * m_sideways;
                addElement(centre + radius * outward,
                           weight * angleWeight * (radius * outward - radiusTimesSlope * m_view.axis));
            });
        });
    }

    /// A whole circle by the trapezoidal rule, exact for the trigonometric cubics here; part of one by Gauss.
    template <typename Visit>
    void roundWetArc(double depthOnAxis, double reach, const Visit& visit) const {
        static const GaussLegendre<10> gauss;
        constexpr int whole = 8;
        if (depthOnAxis >= reach) {
            for (int i = 0; i < whole; ++i)
                visit(2 * pi * i / whole, 2 * pi / whole);
        } else if (depthOnAxis > -reach) {
            const double half = pi - std::acos(depthOnAxis / reach);
            for (std::size_t i = 0; i < gauss.nodes.size(); ++i)
                visit(pi + half * gauss.nodes[i], half * gauss.weights[i]);
        }
    }

    /// A flat end, as lines across it.
    void addDisc(double x, double radius, double outwardSign) {
        static const SineQuadrature<8> alongS;
        static const GaussLegendre<4> acrossS;
        if (!(radius > 0)) return;
        const double depthOnAxis = m_view.depth(x), reach = m_view.upAcross * radius;
        const double end = depthOnAxis >= reach    ? radius
                           : depthOnAxis <= -reach ? -radius
                                                   : depthOnAxis / m_view.upAcross;
        alongS.over(-radius, end, [&](double s, double weight) {
            const double half = std::sqrt(std::max(0.0, radius * radius - s * s));
            for (std::size_t i = 0; i < acrossS.nodes.size(); ++i)
                addElement(m_view.origin + x * m_view.axis + s * m_view.rising +
                               half * acrossS.nodes[i] * m_sideways,
                           outwardSign * weight * half * acrossS.weights[i] * m_view.axis);
        });
    }

    const SolidOfRevolution& m_solid;
    const WaterPatch& m_water;
    const TangentWater& m_tangent;
    AxisInWater m_view;
    Vec3 m_sideways;
    WetIntegrals& m_integrals;
};

/// The part of a ball of radius r about the origin that lies below the plane at the height c along `normal`.
class Cap {
public:
    Cap(double r, double c, const Vec3& normal) : m_height(c), m_circle2(r * r - c * c), m_normal(normal) {
        const auto powers = [&](int n) { return (std::pow(c, n) - std::pow(-r, n)) / n; };
        m_volume = pi * (r * r * powers(1) - powers(3));
        m_moment = -pi / 4 * m_circle2 * m_circle2;
        m_squareAlong = pi * (r * r * powers(3) - powers(5));
        m_squareAcross = pi / 4 * (std::pow(r, 4) * powers(1) - 2 * r * r * powers(3) + powers(5));
    }

    /// Of q over the volume.
    double integral(const Quadratic& q) const {
        return m_volume * q.value + m_moment * m_normal.dot(q.gradient) +
               (m_squareAlong * along(q) + m_squareAcross * (q.bend.trace() - along(q))) / 2;
    }

    /// Of q n over the sphere below the plane, by the divergence theorem: the volume without its lid.
    Vec3 surfaceIntegral(const Quadratic& q) const {
        const double overLid =
            pi * m_circle2 * (q.at(m_height * m_normal) + m_circle2 / 8 * (q.bend.trace() - along(q)));
        return m_volume * q.gradient + m_moment * (q.bend * m_normal) - overLid * m_normal;
    }

private:
    double along(const Quadratic& q) const { return m_normal.dot(q.bend * m_normal); }

    double m_height, m_circle2;  // of the plane, and the square of the radius at which it cuts the sphere
    Vec3 m_normal;
    double m_volume, m_moment, m_squareAlong, m_squareAcross;
};

/// A quadratic less a linear function, about a point at `offset` from the quadratic's own.
Quadratic difference(const Quadratic& q, const Vec3& offset, double value, const Vec3& gradient) {
    return {q.at(offset) - value, q.gradient + q.bend * offset - gradient, q.bend};
}

/// Upper bound of how far depth and head stray from the tangent water within `reach` (m) of where it touches.
double strayedWithin(double reach, const WaterExpansion& expansion, const Vec3& touched,
                     const WaterPatch& water) {
    const double bend = std::max(expansion.head.bend.norm(), expansion.depth.bend.norm());
    return bend / 2 * reach * reach +
           water.errorWithin(expansion, (touched - expansion.centre).norm() + reach);
}

/// Distances from the middle of a solid, in space or, where only that counts, in plan.
double reachOf(const SolidOfRevolution& solid, const Sphere& around, const WaterPatch& water) {
    if (water.pressure() == PressureModel::waveDynamic)
        return 2 * around.radius;  // it may touch off the middle
    const double along = water.upInBody().dot(solid.axis);
    double radius = 0;
    for (const ProfilePiece& piece : solid.profile)
        radius = std::max(radius, largestRadius(piece));
    return std::sqrt(std::max(0.0, 1 - along * along)) *
               (solid.profile.back().end - solid.profile.front().begin) / 2 +
           radius;
}

}  // namespace

void addSolidInWaves(const SolidOfRevolution& solid, const WaterPatch& water, double headError,
                     const HydrostaticQuery& query, WetIntegrals& integrals) {
    const Sphere around = sphereAround(solid);
    const WaterExpansion& expansion = water.near(around.centre);
    const TangentWater tangent(expansion, water.upInBody(), around.centre, around.radius);
    WetIntegrals inTangentWater;
    addSolid(solid, tangent.plane, query, inTangentWater);
    tangent.add(inTangentWater, integrals);

    const double strayed = strayedWithin(reachOf(solid, around, water), expansion, around.centre, water);
    if (strayed <= negligible * headError) {
        integrals.error += Vec3::Constant(strayed * surfaceArea(solid));
        return;
    }
    StrayingWater(solid, water, tangent, integrals).add();
    const double band = strayed / tangent.steepnessUpright;
    integrals.lastingError += Vec3::Constant(
        strayed * (wettedAreaIn(solid, tangent.plane, band) - wettedAreaIn(solid, tangent.plane, -band)));
}

void addSphereInWaves(const Sphere& sphere, const WaterPatch& water, const HydrostaticQuery& query,
                      WetIntegrals& integrals) {
    const WaterExpansion& expansion = water.near(sphere.centre);
    const double r = sphere.radius;
    const TangentWater tangent(expansion, water.upInBody(), sphere.centre, r);
    WetIntegrals inTangentWater;
    addSphere(sphere, tangent.plane, query, inTangentWater);
    tangent.add(inTangentWater, integrals);

    const double distance = tangent.plane.depth(sphere.centre);
    if (distance > -r) {
        const Vec3 offset = sphere.centre - expansion.centre,
                   head = -tangent.steepness * tangent.plane.upInBody,
                   depth = head / tangent.steepnessUpright;
        const Quadratic straysHead = difference(expansion.head, offset, tangent.head(sphere.centre), head);
        const Quadratic straysDepth =
            difference(expansion.depth, offset, tangent.depth(sphere.centre), depth);
        const Cap wet(r, std::min(distance, r), tangent.plane.upInBody);
        const Vec3 force = wet.surfaceIntegral(straysHead);
        const double volume = -water.upInBody().dot(wet.surfaceIntegral(straysDepth));
        integrals.headNormal += force;
        integrals.headTorque += sphere.centre.cross(force);  // all pressure acts through the centre
        integrals.volume += volume;
        integrals.volumeMoment += volume * sphere.centre;
        integrals.headVolume += wet.integral(straysHead);
    }
    const double reach = water.pressure() == PressureModel::hydrostatic ? r : 2 * r;
    const double strayed = strayedWithin(reach, expansion, sphere.centre, water);
    const auto wetHeight = [&](double raised) { return std::clamp(distance + raised + r, 0.0, 2 * r); };
    const double band = strayed / tangent.steepnessUpright;
    const double bandArea = 2 * pi * r * (wetHeight(band) - wetHeight(-band));
    const double error = water.errorWithin(expansion, (sphere.centre - expansion.centre).norm() + r);
    integrals.lastingError += Vec3::Constant(error * 2 * pi * r * wetHeight(band) + strayed * bandArea);
}

}  // namespace bullet_buoyancy
