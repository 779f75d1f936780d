#include "bullet_buoyancy/hydrostatics/solid_integrals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/quadrature.h"
#include "bullet_buoyancy/hydrostatics/solid_sections.h"

namespace bullet_buoyancy {

namespace {

/// Sums over the solid in axial coordinates: integrals over the displaced volume of 1, x, s and depth.
struct AxialSums {
    double volume = 0, xMoment = 0, sMoment = 0, depthVolume = 0;
};

/// Moves the origin to where a steep axis crosses the surface: the depth there is exactly 0, and no digits
/// cancel between the depth and the nearly upright section.
double shiftToSurface(AxisInWater& view) {
    if (std::abs(view.upAlong) <= view.upAcross) return 0;
    const double shift = view.depthAtOrigin / view.upAlong;
    view.origin += shift * view.axis;
    view.depthAtOrigin = 0;
    return shift;
}

ProfilePiece shifted(const ProfilePiece& piece, double shift) {
    return {piece.begin - shift, piece.end - shift, piece.radiusSquared(shift),
            piece.c1 + 2 * shift * piece.c2, piece.c2};
}

void addWholeSections(const ProfilePiece& piece, const AxisInWater& view, double begin, double end,
                      AxialSums& sums) {
    const RadiusMoments moments = radiusMoments(piece, begin, end);
    sums.volume += pi * moments.zeroth;
    sums.xMoment += pi * moments.first;
    sums.depthVolume += pi * (view.depthAtOrigin * moments.zeroth - view.upAlong * moments.first);
}

/// A section of radius r that the surface cuts at s = c, half a chord w to either side: wet where s < c.
struct CutSection {
    double c, w, radiusSquared;

    CutSection(double depth, double upAcross, double radius2)
        : c(depth / upAcross), w(std::sqrt(std::max(0.0, radius2 - c * c))), radiusSquared(radius2) {}

    double wetAngle() const { return pi + 2 * std::atan2(c, w); }  // of the circle, 0 to 2 pi
    double area() const { return radiusSquared * wetAngle() / 2 + c * w; }
    double sMoment() const { return -2 * w * w * w / 3; }
};

void addCutSections(const ProfilePiece& piece, const AxisInWater& view, double begin, double end,
                    const HydrostaticQuery& query, AxialSums& sums, WetIntegrals& integrals) {
    static const SineQuadrature<16> quadrature;
    const Vec3 sideways = view.axis.cross(view.rising);
    quadrature.over(begin, end, [&](double x, double weight) {
        const CutSection section(view.depth(x), view.upAcross, piece.radiusSquared(x));
        const double area = weight * section.area(), sMoment = weight * section.sMoment();
        sums.volume += area;
        sums.xMoment += x * area;
        sums.sMoment += sMoment;
        sums.depthVolume += view.depth(x) * area - view.upAcross * sMoment;
        if (query.wettedArea)
            integrals.wettedArea += weight * section.wetAngle() * piece.radiusTimesArcLength(x);
        if (query.needsWaterplane()) {
            const double strip = weight * 2 * section.w / view.upAcross;
            integrals.addWaterplane(strip, view.origin + x * view.axis + section.c * view.rising,
                                    strip * section.w * section.w / 3 * sideways * sideways.transpose());
        }
    });
}

/// The waterplane of a solid whose axis stands exactly upright: a disc.
void addUprightWaterplane(const ProfilePiece& piece, const AxisInWater& view, WetIntegrals& integrals) {
    if (!(piece.begin <= 0 && 0 < piece.end)) return;
    const Mat3 horizontal = Mat3::Identity() - view.axis * view.axis.transpose();
    integrals.addWaterplane(pi * piece.c0, view.origin, pi * piece.c0 * piece.c0 / 4 * horizontal);
}

double wetDiscArea(const AxisInWater& view, double x, double radiusSquared) {
    if (std::abs(view.depth(x)) < view.upAcross * std::sqrt(radiusSquared))
        return CutSection(view.depth(x), view.upAcross, radiusSquared).area();
    return view.depth(x) > 0 ? pi * radiusSquared : 0;
}

void addPiece(const ProfilePiece& piece, const AxisInWater& view, const HydrostaticQuery& query,
              AxialSums& sums, WetIntegrals& integrals) {
    const std::array<double, 4> ends = stretchEnds(piece, view);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double begin = ends[i], end = ends[i + 1], middle = (begin + end) / 2;
        if (!(end > begin)) continue;
        const double reach = view.upAcross * std::sqrt(std::max(0.0, piece.radiusSquared(middle)));
        if (std::abs(view.depth(middle)) < reach) {
            addCutSections(piece, view, begin, end, query, sums, integrals);
        } else if (view.depth(middle) > 0) {
            addWholeSections(piece, view, begin, end, sums);
            if (query.wettedArea)
                integrals.wettedArea += 2 * pi * piece.radiusTimesArcLength(middle) * (end - begin);
        }
    }
    if (query.needsWaterplane() && view.upAcross == 0) addUprightWaterplane(piece, view, integrals);
}

/// How a plane cuts a sphere.
struct CutSphere {
    double centreDepth;  // m
    double immersion;    // height of what is wet, m
    double waterline2;   // squared radius of the circle that is cut; 0 if none is, m^2

    CutSphere(const Sphere& sphere, const WaterPlane& plane)
        : centreDepth(plane.depth(sphere.centre)),
          immersion(std::clamp(centreDepth + sphere.radius, 0.0, 2 * sphere.radius)),
          waterline2(immersion * (2 * sphere.radius - immersion)) {}

    /// The integral over the displacement of height above the centre, negated; m^4.
    double centreMoment() const { return pi / 4 * waterline2 * waterline2; }
};

}  // namespace

Displacement displacementOf(const Sphere& sphere, const WaterPlane& plane) {
    const CutSphere cut(sphere, plane);
    const double volume = pi * cut.immersion * cut.immersion * (sphere.radius - cut.immersion / 3);
    return {volume, volume * sphere.centre - cut.centreMoment() * plane.upInBody,
            cut.centreDepth * volume + cut.centreMoment()};
}

void addSphere(const Sphere& sphere, const WaterPlane& plane, const HydrostaticQuery& query,
               WetIntegrals& integrals) {
    const CutSphere cut(sphere, plane);
    if (cut.immersion == 0) return;
    integrals.addDisplacement(plane.upInBody, displacementOf(sphere, plane));
    if (query.wettedArea) integrals.wettedArea += 2 * pi * sphere.radius * cut.immersion;
    if (query.needsWaterplane())
        integrals.addWaterplane(
            pi * cut.waterline2, sphere.centre + cut.centreDepth * plane.upInBody,
            cut.centreMoment() * (Mat3::Identity() - plane.upInBody * plane.upInBody.transpose()));
}

void addSolid(const SolidOfRevolution& solid, const WaterPlane& plane, const HydrostaticQuery& query,
              WetIntegrals& integrals) {
    AxisInWater view = axisInWater(solid, plane);
    const double shift = shiftToSurface(view);
    AxialSums sums;
    for (const ProfilePiece& piece : solid.profile)
        addPiece(shifted(piece, shift), view, query, sums, integrals);
    const Vec3 moment = sums.volume * view.origin + sums.xMoment * view.axis + sums.sMoment * view.rising;
    integrals.addDisplacement(plane.upInBody, {sums.volume, moment, sums.depthVolume});
    if (query.wettedArea)
        for (const auto& [piece, x] : {std::pair(solid.profile.front(), solid.profile.front().begin),
                                       std::pair(solid.profile.back(), solid.profile.back().end)})
            integrals.wettedArea += wetDiscArea(view, x - shift, std::max(0.0, piece.radiusSquared(x)));
}

}  // namespace bullet_buoyancy
