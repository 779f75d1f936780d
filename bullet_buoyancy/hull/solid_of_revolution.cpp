#include "bullet_buoyancy/hull/solid_of_revolution.h"

#include <cassert>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/core/quadrature.h"

namespace bullet_buoyancy {

namespace {

/// A sphere about `centre` on the axis.
ProfilePiece sphericalPiece(double begin, double end, double centre, double radius) {
    return {begin, end, radius * radius - centre * centre, 2 * centre, -1};
}

/// 2 pi r ds is constant along spheres and cylinders and linear along cones: the value at the middle is the
/// mean.
double lateralArea(const ProfilePiece& piece) {
    return 2 * pi * piece.radiusTimesArcLength((piece.begin + piece.end) / 2) * (piece.end - piece.begin);
}

}  // namespace

SolidOfRevolution makeCylinder(const Vec3& centre, const Vec3& axis, double radius, double halfHeight) {
    return {centre, axis, {{-halfHeight, halfHeight, radius * radius, 0, 0}}};
}

SolidOfRevolution makeCone(const Vec3& centreOfBase, const Vec3& axis, double radius, double height) {
    const double slope = radius / height;
    return {centreOfBase, axis, {{0, height, radius * radius, -2 * radius * slope, slope * slope}}};
}

SolidOfRevolution makeTaperedCapsule(const Vec3& centreA, double radiusA, const Vec3& centreB,
                                     double radiusB) {
    const double distance = (centreB - centreA).norm(), difference = radiusA - radiusB;
    assert(distance > std::abs(difference));
    // The common tangent cone touches each sphere where its normal leans by sine towards the smaller one.
    // Axial coordinates count from the cone's middle: where one sphere is almost within the other it is as
    // steep as short.
    const double sine = difference / distance;
    const double cosine = std::sqrt((distance - difference) * (distance + difference)) / distance;
    const double halfCone = distance * cosine * cosine / 2, slope = -sine / cosine;
    const double middleRadius = (radiusA + radiusB) / 2 * cosine;
    const double a = -halfCone - radiusA * sine, b = halfCone - radiusB * sine;  // the spheres' centres
    const Vec3 axis = (centreB - centreA) / distance;
    return {centreA - a * axis,
            axis,
            {sphericalPiece(a - radiusA, -halfCone, a, radiusA),
             {-halfCone, halfCone, middleRadius * middleRadius, 2 * middleRadius * slope, slope * slope},
             sphericalPiece(halfCone, b + radiusB, b, radiusB)}};
}

SolidOfRevolution asSolidOfRevolution(const Sphere& sphere) {
    return {sphere.centre, Vec3::UnitX(), {sphericalPiece(-sphere.radius, sphere.radius, 0, sphere.radius)}};
}

VolumeMoments volumeMoments(const SolidOfRevolution& solid) {
    static const GaussLegendre<3> rule;  // exact for the second moments, of fourth degree along the axis
    const Mat3 along = solid.axis * solid.axis.transpose(), across = Mat3::Identity() - along;
    VolumeMoments moments;
    double axialMoment = 0;
    for (const ProfilePiece& piece : solid.profile) {
        const RadiusMoments integrals = radiusMoments(piece, piece.begin, piece.end);
        moments.volume += pi * integrals.zeroth;
        axialMoment += pi * integrals.first;
        const double middle = (piece.begin + piece.end) / 2, half = (piece.end - piece.begin) / 2;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double x = middle + half * rule.nodes[i], radius2 = piece.radiusSquared(x);
            moments.secondMoment +=
                half * rule.weights[i] * pi * radius2 * (x * x * along + radius2 / 4 * across);
        }
    }
    moments.firstMoment = axialMoment * solid.axis;
    return moved(moments, solid.origin);
}

double surfaceArea(const SolidOfRevolution& solid) {
    const ProfilePiece &first = solid.profile.front(), &last = solid.profile.back();
    double area = pi * (first.radiusSquared(first.begin) + last.radiusSquared(last.end));
    for (const ProfilePiece& piece : solid.profile)
        area += lateralArea(piece);
    return area;
}

}  // namespace bullet_buoyancy
