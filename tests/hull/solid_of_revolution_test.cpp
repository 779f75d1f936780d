#include "bullet_buoyancy/hull/solid_of_revolution.h"

#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/mesh_edges.h"
#include "bullet_buoyancy/hull/place_part.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hull/weld.h"
#include "bullet_buoyancy/hull/winding_number.h"
#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

/// Closed forms of numbers of the order of 1, with some ten roundings each.
constexpr double rounding = 100 * epsilon;

struct NamedSolid {
    const char* name;
    SolidOfRevolution solid;
};

std::vector<NamedSolid> solids() {
    const Vec3 axis = Vec3(2, -1, 2) / 3, centre(0.3, -0.2, 0.1);
    return {
        {"cylinder", makeCylinder(centre, axis, 0.4, 0.5)},
        {"disc", makeCylinder(centre, axis, 0.6, 0.05)},
        {"cone", makeCone(centre, axis, 0.4, 0.9)},
        {"flat cone", makeCone(centre, axis, 0.9, 0.1)},
        {"capsule", makeTaperedCapsule(centre, 0.3, centre + 0.8 * axis, 0.3)},
        {"tapered capsule", makeTaperedCapsule(centre, 0.4, centre + 0.8 * axis, 0.15)},
        {"capsule that grows", makeTaperedCapsule(centre, 0.1, centre + 0.5 * axis, 0.4)},
        {"capsule almost a sphere", makeTaperedCapsule(centre, 0.4, centre + 0.31 * axis, 0.1)},
        {"sphere", asSolidOfRevolution({centre, 0.5})},
    };
}

/// Frustum between the circles in which its spheres touch a common tangent cone, and two spherical caps: the
/// angle of the cone and everything else from school geometry, about the first sphere's centre along the
/// axis.
struct TaperedCapsule {
    double volume = 0, axialMoment = 0, area = 0;

    TaperedCapsule(double a, double b, double distance) {
        const double lean = std::asin((a - b) / distance);
        const double xa = a * std::sin(lean), xb = distance + b * std::sin(lean);
        const double ra = a * std::cos(lean), rb = b * std::cos(lean), h = xb - xa;
        const double frustum = pi * h / 3 * (ra * ra + ra * rb + rb * rb);
        const double frustumCentre =
            h / 4 * (ra * ra + 2 * ra * rb + 3 * rb * rb) / (ra * ra + ra * rb + rb * rb);
        volume = frustum;
        axialMoment = frustum * (xa + frustumCentre);
        area = pi * (ra + rb) * std::hypot(h, ra - rb);
        addCap(0, a, a + xa, -1);
        addCap(distance, b, b - (xb - distance), 1);
    }

private:
    /// A cap of height h at the left (-1) or right (1) end of a sphere.
    void addCap(double centre, double radius, double h, double side) {
        const double cap = pi * h * h * (radius - h / 3);
        const double fromCentre = 3 * std::pow(2 * radius - h, 2) / (4 * (3 * radius - h));
        volume += cap;
        axialMoment += cap * (centre + side * fromCentre);
        area += 2 * pi * radius * h;
    }
};

TEST(SolidOfRevolution, CylinderHasItsVolumeCentreAndArea) {
    const Vec3 centre(1, 2, 3), axis = Vec3(1, 2, 2) / 3;
    for (const auto& [r, h] : {std::pair(0.5, 1.0), std::pair(2.0, 0.01), std::pair(0.01, 3.0)}) {
        const SolidOfRevolution solid = makeCylinder(centre, axis, r, h / 2);
        EXPECT_NEAR(volumeMoments(solid).volume, pi * r * r * h, rounding);
        EXPECT_TRUE(isNear(volumeMoments(solid).centroid(), centre, rounding));
        EXPECT_NEAR(surfaceArea(solid), 2 * pi * r * (r + h), rounding);
    }
}

TEST(SolidOfRevolution, ConeHasItsCentreAQuarterUp) {
    const Vec3 centreOfBase(1, 2, 3), axis = Vec3(1, 2, 2) / 3;
    for (const auto& [r, h] : {std::pair(0.5, 1.0), std::pair(2.0, 0.01), std::pair(0.01, 3.0)}) {
        const SolidOfRevolution solid = makeCone(centreOfBase, axis, r, h);
        EXPECT_NEAR(volumeMoments(solid).volume, pi * r * r * h / 3, rounding);
        // The moment, of the order of the volume times its distance of 4 m, over the volume.
        EXPECT_TRUE(isNear(volumeMoments(solid).centroid(), centreOfBase + h / 4 * axis, rounding));
        EXPECT_NEAR(surfaceArea(solid), pi * r * (r + std::hypot(r, h)), rounding);
    }
}

TEST(SolidOfRevolution, SphereIsOneAboutAnyAxis) {
    const Sphere sphere{{1, 2, 3}, 0.7};
    const SolidOfRevolution solid = asSolidOfRevolution(sphere);
    EXPECT_NEAR(volumeMoments(solid).volume, 4 * pi / 3 * 0.343, rounding);
    EXPECT_TRUE(isNear(volumeMoments(solid).centroid(), sphere.centre, rounding));
    EXPECT_NEAR(surfaceArea(solid), 4 * pi * 0.49, rounding);
    EXPECT_NEAR(volumeMoments(sphere).volume, 4 * pi / 3 * 0.343, rounding);
    EXPECT_TRUE(isNear(volumeMoments(sphere).centroid(), sphere.centre, rounding));
    EXPECT_NEAR(surfaceArea(sphere), 4 * pi * 0.49, rounding);
}

TEST(SolidOfRevolution, CapsuleIsACylinderAndASphere) {
    const Vec3 a(1, 2, 3), axis = Vec3(1, 2, 2) / 3;
    const double r = 0.3, h = 0.8;
    const SolidOfRevolution solid = makeTaperedCapsule(a, r, a + h * axis, r);
    EXPECT_NEAR(volumeMoments(solid).volume, pi * r * r * (h + 4 * r / 3), rounding);
    EXPECT_TRUE(isNear(volumeMoments(solid).centroid(), a + h / 2 * axis, rounding));
    EXPECT_NEAR(surfaceArea(solid), 2 * pi * r * (h + 2 * r), rounding);
}

TEST(SolidOfRevolution, TaperedCapsuleIsAFrustumBetweenTwoCaps) {
    const Vec3 axis = Vec3(1, 2, 2) / 3;
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.uniform(0.1, 1), b = random.uniform(0.1, 1);
        const double distance = std::abs(a - b) + random.uniform(0.05, 2);
        const Vec3 centre = random.inCube(1);
        const SolidOfRevolution solid = makeTaperedCapsule(centre, a, centre + distance * axis, b);
        const TaperedCapsule expected(a, b, distance);
        EXPECT_NEAR(volumeMoments(solid).volume, expected.volume, rounding * (1 + expected.volume));
        const Vec3 moment = expected.volume * centre + expected.axialMoment * axis;
        EXPECT_TRUE(isNear(volumeMoments(solid).firstMoment, moment, 10 * rounding * (1 + expected.volume)));
        // Where the spheres nearly swallow each other the cone is steep: its slope of up to 6 multiplies
        // roundings.
        EXPECT_NEAR(surfaceArea(solid), expected.area, 100 * rounding * (1 + expected.area));
    }
}

TEST(SolidOfRevolution, TaperedCapsuleTendsToTheCapsule) {
    const Vec3 b(0, 0, 0.8);
    const VolumeMoments capsule = volumeMoments(makeTaperedCapsule(Vec3::Zero(), 0.3, b, 0.3));
    for (double difference : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const VolumeMoments tapered =
            volumeMoments(makeTaperedCapsule(Vec3::Zero(), 0.3, b, 0.3 + difference));
        // The volume changes by at most the difference times the larger one's area, 2 pi r (h + 2 r) and a
        // little.
        EXPECT_LE(std::abs(tapered.volume - capsule.volume), 2.7 * difference + rounding);
        EXPECT_TRUE(isNear(tapered.firstMoment, capsule.firstMoment, 2.7 * 1.1 * difference + rounding));
    }
}

TEST(SolidOfRevolution, TaperedCapsuleTendsToTheSphereThatHoldsTheOther) {
    // The cone between the spheres becomes as steep as it is short: up to a slope of 1e7.
    const double volume = 4 * pi / 3 * 0.125;
    for (double margin : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const SolidOfRevolution solid =
            makeTaperedCapsule(Vec3::Zero(), 0.5, (0.3 + margin) * Vec3::UnitY(), 0.2);
        EXPECT_GT(volumeMoments(solid).volume, volume - rounding) << margin;
        // The small sphere sticks out by the margin, within a circle that shrinks with it.
        EXPECT_LT(volumeMoments(solid).volume, volume + 10 * margin * margin + rounding) << margin;
        EXPECT_TRUE(isNear(volumeMoments(solid).firstMoment, Vec3::Zero(), 10 * margin * margin + rounding));
        EXPECT_NEAR(surfaceArea(solid), pi, 10 * margin + rounding) << margin;
        for (const ProfilePiece& piece : solid.profile)
            for (double x : {piece.begin, piece.end})
                EXPECT_GT(piece.radiusSquared(x), -rounding) << margin;
    }
}

TEST(SolidOfRevolution, PiecesMeetWithEqualRadii) {
    for (const auto& [name, solid] : solids())
        for (std::size_t i = 0; i + 1 < solid.profile.size(); ++i) {
            const ProfilePiece &left = solid.profile[i], &right = solid.profile[i + 1];
            EXPECT_EQ(left.end, right.begin) << name;
            EXPECT_NEAR(left.radiusSquared(left.end), right.radiusSquared(right.begin), 10 * rounding)
                << name;
        }
}

TEST(SolidOfRevolution, PlacedIsScaledTurnedAndMoved) {
    Random random(2);
    for (const auto& [name, solid] : solids())
        for (int i = 0; i < 20; ++i) {
            const Pose pose{random.inCube(1), random.orientation()};
            const double scale = random.uniform(0.5, 2);
            const auto part = std::get<SolidOfRevolution>(placed(solid, pose, scale));
            const VolumeMoments before = volumeMoments(solid), after = volumeMoments(part);
            const Vec3 centre = pose.position + pose.orientation * (scale * before.centroid());
            EXPECT_NEAR(after.volume, std::pow(scale, 3) * before.volume, 10 * rounding) << name;
            EXPECT_TRUE(isNear(after.firstMoment, after.volume * centre, 100 * rounding)) << name;
            EXPECT_NEAR(surfaceArea(part), scale * scale * surfaceArea(solid), 1000 * rounding) << name;
        }
}

TEST(Tessellation, IsClosedAndOutward) {
    Random random(3);
    const auto check = [&](TriangleMesh mesh, const VolumeMoments& whole, const char* name) {
        weld(mesh, 1e-9);
        EXPECT_EQ(countOpenEdges(mesh), 0u) << name;
        EXPECT_GT(volumeMoments(mesh).volume, 0.9 * whole.volume) << name;
        EXPECT_LT(volumeMoments(mesh).volume, whole.volume) << name << " is convex: a mesh on it lies within";
        EXPECT_NEAR(windingNumber(mesh, whole.centroid()), 1, 1e4 * epsilon) << name;
        EXPECT_NEAR(windingNumber(mesh, 3 * random.direction()), 0, 1e4 * epsilon) << name;
    };
    for (const auto& [name, solid] : solids())
        for (int segments : {15, 16, 48})
            check(tessellate(solid, segments), volumeMoments(solid), name);
    const Sphere sphere{{0.3, -0.2, 0.1}, 0.5};
    for (int levels : {2, 3})
        check(tessellate(sphere, levels), volumeMoments(sphere), "icosphere");
}

TEST(Tessellation, HasItsVerticesOnTheSurface) {
    const Sphere sphere{{0.3, -0.2, 0.1}, 0.5};
    for (const Vec3& vertex : tessellate(sphere, 3).vertices)
        EXPECT_NEAR((vertex - sphere.centre).norm(), sphere.radius, rounding);
    for (const auto& [name, solid] : solids())
        for (const Vec3& vertex : tessellate(solid, 20).vertices) {
            const double x = (vertex - solid.origin).dot(solid.axis);
            const double radiusSquared = (vertex - solid.origin).squaredNorm() - x * x;
            double nearest = 1;
            for (const ProfilePiece& piece : solid.profile)
                if (x >= piece.begin - rounding && x <= piece.end + rounding)
                    nearest = std::min(nearest, std::abs(piece.radiusSquared(x) - radiusSquared));
            EXPECT_LE(nearest, 10 * rounding) << name;
        }
}

TEST(Tessellation, TendsToTheSolidQuadratically) {
    // Chords miss a curve by the square of their length. What is left is of the fourth order: below 5 % here.
    for (const auto& [name, solid] : solids()) {
        const TriangleMesh coarse = tessellate(solid, 48), fine = tessellate(solid, 96);
        const double volume = volumeMoments(solid).volume, area = surfaceArea(solid);
        EXPECT_NEAR((volume - volumeMoments(coarse).volume) / (volume - volumeMoments(fine).volume), 4, 0.2)
            << name;
        EXPECT_NEAR((area - surfaceArea(coarse)) / (area - surfaceArea(fine)), 4, 0.2) << name;
    }
    const Sphere sphere{{0.3, -0.2, 0.1}, 0.5};
    const TriangleMesh coarse = tessellate(sphere, 3), fine = tessellate(sphere, 4);
    const double volume = volumeMoments(sphere).volume, area = surfaceArea(sphere);
    EXPECT_NEAR((volume - volumeMoments(coarse).volume) / (volume - volumeMoments(fine).volume), 4, 0.2);
    EXPECT_NEAR((area - surfaceArea(coarse)) / (area - surfaceArea(fine)), 4, 0.2);
}

TEST(Tessellation, OfASphereHasTwentyTimesFourToTheLevelTriangles) {
    for (int levels : {0, 1, 2, 3})
        EXPECT_EQ(tessellate(Sphere{Vec3::Zero(), 1}, levels).triangles.size(), 20u << (2 * levels));
    // An icosahedron of edge a = 1 / sin(2 pi / 5) has the volume 5 (3 + sqrt 5) / 12 a^3.
    const double edge = 1 / std::sin(2 * pi / 5);
    EXPECT_NEAR(volumeMoments(tessellate(Sphere{Vec3::Zero(), 1}, 0)).volume,
                5 * (3 + std::sqrt(5.0)) / 12 * std::pow(edge, 3), rounding);
}

}  // namespace
}  // namespace bullet_buoyancy::test
