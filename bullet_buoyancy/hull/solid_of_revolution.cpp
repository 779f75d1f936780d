#include "bullet_buoyancy/hull/solid_of_revolution.h"

#include <cassert>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

namespace {

/// A sphere about `centre` on the axis.
ProfilePiece sphericalPiece(double begin, double end, double centre, double radius) {
    return {begin, end, radius * radius - centre * centre, 2 * centre, -1};
}

/// Integral of x^power radius^2 over the piece.
double radiusSquaredMoment(const ProfilePiece& piece, int power) {
    const auto integral = [&](double x) {
        const double xn = std::pow(x, power + 1);
        return xn * (piece.c0 / (power + 1) + x * (piece.c1 / (power + 2) + x * piece.c2 / (power + 3)));
    };
    return integral(piece.end) - integral(piece.begin);
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
    const double distance = (centreB - centreA).norm();
    assert(distance > std::abs(radiusA - radiusB));
    // The common tangent cone touches each sphere where its normal leans by sine towards the smaller one.
    const double sine = (radiusA - radiusB) / distance;
    const double slope = -sine / std::sqrt(1 - sine * sine);
    const double touchA = radiusA * sine;
    const double touchB = distance + radiusB * sine;
    const double r0 = radiusA * std::sqrt(1 - sine * sine) - slope * touchA;  // of the cone at x = 0
    return {centreA,
            (centreB - centreA) / distance,
            {sphericalPiece(-radiusA, touchA, 0, radiusA),
             {touchA, touchB, r0 * r0, 2 * r0 * slope, slope * slope},
             sphericalPiece(touchB, distance + radiusB, distance, radiusB)}};
}

SolidOfRevolution asSolidOfRevolution(const Sphere& sphere) {
    return {sphere.centre, Vec3::UnitX(), {sphericalPiece(-sphere.radius, sphere.radius, 0, sphere.radius)}};
}

VolumeMoments volumeMoments(const SolidOfRevolution& solid) {
    VolumeMoments moments;
    double axialMoment = 0;
    for (const ProfilePiece& piece : solid.profile) {
        moments.volume += pi * radiusSquaredMoment(piece, 0);
        axialMoment += pi * radiusSquaredMoment(piece, 1);
    }
    moments.firstMoment = moments.volume * solid.origin + axialMoment * solid.axis;
    return moments;
}

double surfaceArea(const SolidOfRevolution& solid) {
    const ProfilePiece &first = solid.profile.front(), &last = solid.profile.back();
    double area = pi * (first.radiusSquared(first.begin) + last.radiusSquared(last.end));
    for (const ProfilePiece& piece : solid.profile)
        area += lateralArea(piece);
    return area;
}

}  // namespace bullet_buoyancy
