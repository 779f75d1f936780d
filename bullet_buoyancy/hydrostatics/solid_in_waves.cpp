#include "bullet_buoyancy/hydrostatics/solid_in_waves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/solid_bend.h"
#include "bullet_buoyancy/hydrostatics/solid_integrals.h"
#include "bullet_buoyancy/hydrostatics/solid_panels.h"
#include "bullet_buoyancy/hydrostatics/tangent_water.h"

namespace bullet_buoyancy {

namespace {

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

double wettedAreaIn(const Sphere& sphere, const WaterPlane& plane, double raised) {
    const double immersion = plane.depth(sphere.centre) + raised + sphere.radius;
    return 2 * pi * sphere.radius * std::clamp(immersion, 0.0, 2 * sphere.radius);
}

/// Bound of what an evaluation in the tangent water and by its bend leaves out at the waterline, where the
/// water strays from the tangent by up to `strayed`. Over the band that it moves over the head is below
/// strayed, half of it on average, or up to two thirds where the band is nearly level.
template <typename Solid>
double waterlineError(const Solid& solid, const TangentWater& tangent, double strayed) {
    const double band = strayed / tangent.steepnessUpright;
    constexpr double mean = 0.75;
    return mean * strayed *
           (wettedAreaIn(solid, tangent.plane, band) - wettedAreaIn(solid, tangent.plane, -band));
}

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

/// Upper bound of how far depth and head stray from the tangent water within `reach` (m) of the middle.
double strayedWithin(double reach, const WaterExpansion& expansion, const WaterPatch& water) {
    const double bend = std::max(expansion.head.bend.norm(), expansion.depth.bend.norm());
    const double touches =
        water.pressure() == PressureModel::hydrostatic ? reach : 2 * reach;  // off the middle
    return bend / 2 * touches * touches;
}

/// Whether one expansion is all that a body within `around` needs.
bool oneIsEnough(const WaterExpansion& expansion, const Sphere& around, const WaterPatch& water,
                 double headError) {
    if (water.cellCount() == 1) return true;
    return water.errorWithin(expansion, (around.centre - expansion.centre).norm() + around.radius) <=
           headError;
}

/// Most that the closed forms may leave out at the waterline, over what may be off in all.
constexpr double allowedAtWaterline = 0.25;

/// False if what the closed forms leave out would be too much.
bool addInClosedForm(const SolidOfRevolution& solid, const WaterPatch& water, double headError,
                     const HydrostaticQuery& query, WetIntegrals& integrals) {
    const Sphere around = sphereAround(solid);
    const WaterExpansion& expansion = water.near(around.centre);
    if (!oneIsEnough(expansion, around, water, headError)) return false;
    const double strayed = strayedWithin(around.radius, expansion, water);
    if (strayed * strayed > headError * around.radius) return false;

    const TangentWater tangent(expansion, water.upInBody(), around.centre, around.radius);
    WetIntegrals inTangentWater, now = integrals;
    addSolid(solid, tangent.plane, query, inTangentWater);
    tangent.add(inTangentWater, now);
    const BendSummary bend =
        addBend(solid, water, expansion, tangent, BentWater(expansion, tangent, around.centre), now);
    const double strayedThere = std::min(strayed, 1.25 * bend.atWaterline + strayed / 16);
    const double atWaterline = waterlineError(solid, tangent, strayedThere);
    if (atWaterline > allowedAtWaterline * headError * surfaceArea(solid)) return false;
    now.error += bend.error;
    now.lastingError += Vec3::Constant(atWaterline);
    integrals = now;
    return true;
}

/// All pressure acts through the centre.
void addBend(const Sphere& sphere, const WaterPatch& water, const WaterExpansion& expansion,
             const TangentWater& tangent, WetIntegrals& integrals) {
    const double depth = tangent.plane.depth(sphere.centre);
    if (depth <= -sphere.radius) return;
    const BentWater bent(expansion, tangent, sphere.centre);
    const Cap wet(sphere.radius, std::min(depth, sphere.radius), tangent.plane.upInBody);
    const Vec3 force = wet.surfaceIntegral(bent.head);
    const double volume = -water.upInBody().dot(wet.surfaceIntegral(bent.depth));
    integrals.headNormal += force;
    integrals.headTorque += sphere.centre.cross(force);
    integrals.volume += volume;
    integrals.volumeMoment += volume * sphere.centre;
    integrals.headVolume += wet.integral(bent.head);
}

bool addInClosedForm(const Sphere& sphere, const WaterPatch& water, double headError,
                     const HydrostaticQuery& query, WetIntegrals& integrals) {
    const double r = sphere.radius;
    const WaterExpansion& expansion = water.near(sphere.centre);
    if (!oneIsEnough(expansion, sphere, water, headError)) return false;
    const TangentWater tangent(expansion, water.upInBody(), sphere.centre, r);
    const double strayed = strayedWithin(r, expansion, water);
    const double atWaterline = waterlineError(sphere, tangent, strayed);
    if (atWaterline > allowedAtWaterline * headError * surfaceArea(sphere)) return false;

    WetIntegrals inTangentWater;
    addSphere(sphere, tangent.plane, query, inTangentWater);
    tangent.add(inTangentWater, integrals);
    addBend(sphere, water, expansion, tangent, integrals);
    const double error = water.errorWithin(expansion, (sphere.centre - expansion.centre).norm() + r);
    // The shadow of the wet part along an axis, on either side.
    const double projected = std::min(2 * pi * r * r, wettedAreaIn(sphere, tangent.plane, strayed));
    integrals.error += Vec3::Constant(error * projected);
    integrals.lastingError += Vec3::Constant(atWaterline);
    return true;
}

}  // namespace

void addSolidInWaves(const SolidOfRevolution& solid, const WaterPatch& water, double headError,
                     const HydrostaticQuery& query, WetIntegrals& integrals) {
    if (addInClosedForm(solid, water, headError, query, integrals)) return;
    addPanels(RoundBody(solid), water, headError, query, integrals);
}

void addSphereInWaves(const Sphere& sphere, const WaterPatch& water, double headError,
                      const HydrostaticQuery& query, WetIntegrals& integrals) {
    if (addInClosedForm(sphere, water, headError, query, integrals)) return;
    const ProfilePiece piece = pieceOf(sphere);
    addPanels(RoundBody(sphere, piece), water, headError, query, integrals);
}

}  // namespace bullet_buoyancy
