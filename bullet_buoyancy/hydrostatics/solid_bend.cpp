#include "bullet_buoyancy/hydrostatics/solid_bend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "bullet_buoyancy/core/quadrature.h"

namespace bullet_buoyancy {

namespace {

/// A section of a solid across its axis, wet where s < c; `chordHalf` is half of the waterline across it.
struct Section {
    double radius, c, chordHalf, wetAngle;

    Section(double radiusSquared, double depth, double upAcross)
        : radius(std::sqrt(std::max(0.0, radiusSquared))) {
        const double reach = upAcross * radius;
        c = depth >= reach ? radius : depth <= -reach ? -radius : depth / upAcross;
        chordHalf = std::sqrt(std::max(0.0, radius * radius - c * c));
        wetAngle = pi + 2 * std::atan2(c, chordHalf);
    }

    bool isCut() const { return chordHalf > 0; }
    double area() const { return radius * radius * wetAngle / 2 + c * chordHalf; }
    double sMoment() const { return -2 * chordHalf * chordHalf * chordHalf / 3; }

    double quarterFourth() const { return std::pow(radius * radius, 2) * wetAngle / 8; }
    double sSquared() const { return quarterFourth() + c * chordHalf * (2 * c * c - radius * radius) / 4; }
    double ySquared() const {
        return quarterFourth() + c * chordHalf * (chordHalf * chordHalf / 6 + radius * radius / 4);
    }

    /// Upper bound of the integral of the absolute value of the cosine over the wet angle, times the radius.
    double projection() const { return c > 0 ? 2 * (radius + c) : 2 * chordHalf; }
};

/// The integral of r x (bend r), from that of r r^T times the bend.
Vec3 crossOf(const Mat3& m) {
    return {m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)};
}

Quadratic movedTo(const Quadratic& q, const Vec3& offset) {
    return {q.at(offset), q.gradient + q.bend * offset, q.bend};
}

class BentSolid {
public:
    BentSolid(const SolidOfRevolution& solid, const WaterPatch& water, const WaterExpansion& expansion,
              const TangentWater& tangent, const BentWater& bent, WetIntegrals& integrals)
        : m_solid(solid),
          m_water(water),
          m_expansion(expansion),
          m_normal(tangent.plane.upInBody),
          m_shadow(m_normal.dot(water.upInBody())),
          m_bent(bent),
          m_integrals(integrals),
          m_view(axisInWater(solid, tangent.plane)),
          m_sideways(m_view.axis.cross(m_view.rising)),
          m_across((Vec3::Ones() - m_view.axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt()) {
        // A steep axis counts from where it crosses the surface: no digits cancel near an upright section.
        if (std::abs(m_view.upAlong) > m_view.upAcross) {
            m_shift = m_view.depthAtOrigin / m_view.upAlong;
            m_view.origin += m_shift * m_view.axis;
            m_view.depthAtOrigin = 0;
        }
    }

    BendSummary add() {
        for (const ProfilePiece& piece : m_solid.profile)
            addPiece({piece.begin - m_shift, piece.end - m_shift, piece.radiusSquared(m_shift),
                      piece.c1 + 2 * m_shift * piece.c2, piece.c2});
        addVolume();
        const ProfilePiece &first = m_solid.profile.front(), &last = m_solid.profile.back();
        noteDisc(first.begin - m_shift, first.radiusSquared(first.begin));
        noteDisc(last.end - m_shift, last.radiusSquared(last.end));
        return m_summary;
    }

private:
    void addPiece(const ProfilePiece& piece) {
        static const SineQuadrature<8> alongAxis;
        const std::array<double, 4> ends = stretchEnds(piece, m_view);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            if (!(ends[i + 1] > ends[i])) continue;
            const double middle = (ends[i] + ends[i + 1]) / 2;
            if (Section(piece.radiusSquared(middle), m_view.depth(middle), m_view.upAcross).wetAngle == 0)
                continue;
            alongAxis.over(ends[i], ends[i + 1],
                           [&](double x, double weight) { addSection(piece, x, weight); });
        }
        if (m_view.upAcross == 0 && piece.begin <= 0 && 0 < piece.end) addUprightLid(piece.c0);
    }

    void addSection(const ProfilePiece& piece, double x, double weight) {
        const Section section(piece.radiusSquared(x), m_view.depth(x), m_view.upAcross);
        const double area = weight * section.area(), sMoment = weight * section.sMoment();
        m_volume += area;
        m_x += x * area;
        m_s += sMoment;
        m_xx += x * x * area;
        m_xs += x * sMoment;
        m_ss += weight * section.sSquared();
        m_yy += weight * section.ySquared();
        const double error = errorRound(x, section.radius);
        m_summary.error +=
            weight * error *
            (section.projection() * m_across +
             section.wetAngle * std::abs(piece.c1 / 2 + x * piece.c2) * m_view.axis.cwiseAbs());
        if (!section.isCut()) return;
        // Along the chord the integrands are cubic: Simpson's rule.
        const double strip = weight * 2 * section.chordHalf / m_view.upAcross;
        const Vec3 middleOfChord = m_view.origin + x * m_view.axis + section.c * m_view.rising;
        addLid(middleOfChord, strip * 4 / 6);
        for (double side : {-section.chordHalf, section.chordHalf})
            noteWaterline(addLid(middleOfChord + side * m_sideways, strip / 6));
    }

    /// Largest of the expansion's errors round a section, by its extreme points.
    double errorRound(double x, double radius) const {
        const Vec3 centre = m_view.origin + x * m_view.axis;
        double error = 0;
        for (const Vec3& offset : {Vec3(radius * m_view.rising), Vec3(radius * m_sideways)})
            error = std::max({error, m_water.errorAt(m_expansion, centre + offset),
                              m_water.errorAt(m_expansion, centre - offset)});
        return error;
    }

    void noteWaterline(double departure) {
        m_summary.atWaterline = std::max(m_summary.atWaterline, departure);
    }

    /// Returns how far the water strays there.
    double addLid(const Vec3& position, double area) {
        const double depth = m_bent.depth.at(position - m_bent.about),
                     head = m_bent.head.at(position - m_bent.about);
        const Vec3 force = -head * area * m_normal;
        const double volume = depth * area * m_shadow;
        m_integrals.headNormal += force;
        m_integrals.headTorque += position.cross(force);
        m_integrals.volume += volume;
        m_integrals.volumeMoment += volume * (position + depth / 2 * m_water.upInBody());
        m_integrals.headVolume += volume * head / 2;
        return std::max(std::abs(depth), std::abs(head));
    }

    /// A disc, by four points: exact for cubics.
    void addUprightLid(double radiusSquared) {
        const double radius = std::sqrt(std::max(0.0, radiusSquared));
        for (const Vec3& direction : {m_view.rising, m_sideways})
            for (double side : {-radius, radius}) {
                addLid(m_view.origin + side * std::sqrt(0.5) * direction, pi * radiusSquared / 4);
                const Vec3 offset = m_view.origin + side * direction - m_bent.about;
                noteWaterline(std::max(std::abs(m_bent.depth.at(offset)), std::abs(m_bent.head.at(offset))));
            }
    }

    void addVolume() {
        const Quadratic head = movedTo(m_bent.head, m_view.origin - m_bent.about);
        const Vec3 moment = m_x * m_view.axis + m_s * m_view.rising;
        const Mat3 cross = m_xs * m_view.axis * m_view.rising.transpose();
        const Mat3 second = m_xx * m_view.axis * m_view.axis.transpose() + cross + cross.transpose() +
                            m_ss * m_view.rising * m_view.rising.transpose() +
                            m_yy * m_sideways * m_sideways.transpose();
        const Vec3 force = m_volume * head.gradient + head.bend * moment;
        m_integrals.headNormal += force;
        m_integrals.headTorque +=
            m_view.origin.cross(force) + moment.cross(head.gradient) + crossOf(second * head.bend);
        m_integrals.headVolume +=
            m_volume * head.value + moment.dot(head.gradient) + (second * head.bend).trace() / 2;
    }

    void noteDisc(double x, double radiusSquared) {
        const Section section(radiusSquared, m_view.depth(x), m_view.upAcross);
        if (section.wetAngle == 0 || section.radius == 0) return;
        m_summary.error += errorRound(x, section.radius) * section.area() * m_view.axis.cwiseAbs();
    }

    const SolidOfRevolution& m_solid;
    const WaterPatch& m_water;
    const WaterExpansion& m_expansion;
    Vec3 m_normal;    // of the plane
    double m_shadow;  // of its area, straight below
    const BentWater& m_bent;
    WetIntegrals& m_integrals;
    AxisInWater m_view;
    Vec3 m_sideways, m_across;  // m_across: of the body's axes, the part across the solid's
    double m_shift = 0;
    BendSummary m_summary;
    double m_volume = 0, m_x = 0, m_s = 0, m_xx = 0, m_xs = 0, m_ss = 0, m_yy = 0;  // about the view's origin
};

}  // namespace

BentWater::BentWater(const WaterExpansion& water, const TangentWater& tangent, const Vec3& point)
    : about(point),
      depth(movedTo(water.depth, point - water.centre)),
      head(movedTo(water.head, point - water.centre)) {
    const Vec3 gradient = -tangent.steepness * tangent.plane.upInBody;
    depth.value -= tangent.depth(point);
    depth.gradient -= gradient / tangent.steepnessUpright;
    head.value -= tangent.head(point);
    head.gradient -= gradient;
}

BendSummary addBend(const SolidOfRevolution& solid, const WaterPatch& water, const WaterExpansion& expansion,
                    const TangentWater& tangent, const BentWater& bent, WetIntegrals& integrals) {
    return BentSolid(solid, water, expansion, tangent, bent, integrals).add();
}

}  // namespace bullet_buoyancy
