#include "bullet_buoyancy/hull/hull.h"

#include <gtest/gtest.h>

#include <limits>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/mesh_repair.h"
#include "bullet_buoyancy/hull/place_part.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

/// Volumes, moments and areas of numbers of the order of 1 with some hundred roundings.
constexpr double rounding = 1000 * epsilon;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const TriangleMesh unitBox = boxMesh({1, 1, 1});

HullResult make(HullPart part) {
    return makeHull(std::vector<HullPart>{std::move(part)});
}

void expectRefused(const HullResult& result, HullError error) {
    EXPECT_EQ(result.hull, nullptr);
    EXPECT_EQ(result.status.error, error);
    EXPECT_FALSE(result.status.accepted());
}

bool mentions(const HullStatus& status, const std::string& words) {
    return status.describe().find(words) != std::string::npos;
}

TEST(MakeHull, AddsUpItsParts) {
    const TriangleMesh box = boxMesh({1, 2, 3}, {10, 0, 0});
    const Sphere sphere{{0, 20, 0}, 0.5};
    const SolidOfRevolution cone = makeCone({0, 0, 30}, Vec3::UnitX(), 1, 2);
    const HullResult result = makeHull({box, sphere, cone});
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.status.describe(), "ok");
    const Hull& hull = *result.hull;
    EXPECT_EQ(hull.mesh.triangles.size(), 12u);
    EXPECT_EQ(hull.spheres.size(), 1u);
    EXPECT_EQ(hull.solids.size(), 1u);
    const double ball = pi / 6, spire = 2 * pi / 3;
    EXPECT_NEAR(hull.moments.volume, 6 + ball + spire, 10 * rounding);
    const Vec3 moment = 6 * Vec3(10, 0, 0) + ball * Vec3(0, 20, 0) + spire * Vec3(0.5, 0, 30);
    EXPECT_TRUE(isNear(hull.moments.firstMoment, moment, 100 * rounding));
    EXPECT_NEAR(hull.surfaceArea, 22 + pi + pi * (1 + std::sqrt(5.0)), 10 * rounding);
    EXPECT_TRUE(hull.meshIsClosed);
}

TEST(MakeHull, JoinsMeshesAndKeepsTheirTriangles) {
    const TriangleMesh other = boxMesh({1, 1, 1}, {3, 0, 0});
    const HullResult result = makeHull({unitBox, other, Sphere{{0, 5, 0}, 1}});
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.hull->mesh.vertices.size(), 16u);
    EXPECT_EQ(result.hull->mesh.triangles.size(), 24u);
    EXPECT_NEAR(volumeMoments(result.hull->mesh).volume, 2, rounding);
}

TEST(MakeHull, OfSpheresAloneIsClosed) {
    const HullResult result = make(Sphere{Vec3::Zero(), 1});
    ASSERT_TRUE(result.hull);
    EXPECT_TRUE(result.hull->meshIsClosed);
    EXPECT_TRUE(result.hull->mesh.triangles.empty());
}

TEST(MakeHull, BoundsHoldEverything) {
    Random random(1);
    std::vector<NamedHull> hulls = polyhedra();
    for (const NamedHull& solid : smoothSolids())
        hulls.push_back(solid);
    for (const auto& [name, hull] : hulls) {
        const Sphere& bounds = hull->bounds;
        EXPECT_TRUE(std::isfinite(bounds.radius)) << name;
        const double reach = bounds.radius + rounding;
        for (const Vec3& vertex : hull->mesh.vertices)
            EXPECT_LE((vertex - bounds.centre).norm(), reach) << name;
        for (const Sphere& sphere : hull->spheres)
            EXPECT_LE((sphere.centre - bounds.centre).norm() + sphere.radius, reach) << name;
        for (const SolidOfRevolution& solid : hull->solids)
            for (const Vec3& point : tessellate(solid, 200).vertices)
                EXPECT_LE((point - bounds.centre).norm(), reach) << name;
    }
}

/// Half of the integral of |n.direction|.
double shadowOf(const TriangleMesh& mesh, const Vec3& direction) {
    double shadow = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        shadow += std::abs((b - a).cross(c - a).dot(direction)) / 4;
    }
    return shadow;
}

TEST(MakeHull, BoundsShadowsFromAbove) {
    Random random(4);
    const auto box = hullOf(boxMesh({1, 2, 3}, {5, 6, 7}));
    for (int i = 0; i < 20; ++i) {
        const Vec3 direction = random.direction();
        // A box's faces are two to an axis: 6, 3 and 2 m^2.
        EXPECT_NEAR(box->surface.shadowAlong(direction), Vec3(6, 3, 2).dot(direction.cwiseAbs()), rounding);
        for (const NamedHull& named : polyhedra()) {
            const double shadow = named.hull->surface.shadowAlong(direction);
            EXPECT_GE(shadow, (1 - rounding) * shadowOf(named.hull->mesh, direction)) << named.name;
        }
        // The meshes that measure curved parts lie inside, by less than a hundredth.
        for (const NamedHull& named : smoothSolids()) {
            double shadow = 0;
            for (const Sphere& sphere : named.hull->spheres)
                shadow += shadowOf(tessellate(sphere, 5), direction);
            for (const SolidOfRevolution& solid : named.hull->solids)
                shadow += shadowOf(tessellate(solid, 192), direction);
            EXPECT_GE(1.01 * named.hull->surface.shadowAlong(direction), shadow) << named.name;
        }
    }
}

TEST(MakeHull, BoundsOfSimpleThingsAreTight) {
    for (const auto& [name, hull] : polyhedra())
        EXPECT_LE(hull->bounds.radius, meshSize(hull->mesh) / 2 + rounding) << name;
    EXPECT_NEAR(hullOf(boxMesh({2, 4, 4}, {1, 2, 3}))->bounds.radius, 3, rounding);
    EXPECT_TRUE(isNear(hullOf(boxMesh({2, 4, 4}, {1, 2, 3}))->bounds.centre, Vec3(1, 2, 3), rounding));
    EXPECT_NEAR(make(Sphere{{1, 2, 3}, 0.5}).hull->bounds.radius, 0.5, rounding);
    EXPECT_NEAR(make(makeCylinder({1, 2, 3}, Vec3::UnitY(), 3, 4)).hull->bounds.radius, 5, rounding);
}

TEST(MakeHull, BoundsHoldNearlyNestedSpheres) {
    for (double margin : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const HullResult result =
            make(makeTaperedCapsule(Vec3::Zero(), 0.5, (0.3 + margin) * Vec3::UnitZ(), 0.2));
        ASSERT_TRUE(result.hull) << margin;
        EXPECT_GE(result.hull->bounds.radius, 0.5 - rounding) << margin;
        EXPECT_LE(result.hull->bounds.radius, 0.5 * std::sqrt(2.0) + rounding)
            << "a cylinder's, as high as wide";
    }
}

TEST(MakeHull, SaysWhatItRepaired) {
    TriangleMesh mesh = soup(unitBox);
    mesh.triangles[4] = turned(mesh.triangles[4]);
    mesh.triangles.push_back({0, 0, 1});
    const HullResult result = makeHull(mesh);
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.status.weldedVertices, 28u);
    EXPECT_EQ(result.status.degenerateTriangles, 1u);
    EXPECT_EQ(result.status.flippedTriangles, 1u);
    EXPECT_EQ(result.status.openEdges, 0u);
    EXPECT_TRUE(mentions(result.status, "28 repeated or unused vertices"));
    EXPECT_TRUE(mentions(result.status, "1 triangles without area"));
    EXPECT_TRUE(mentions(result.status, "1 triangles turned outward"));
    EXPECT_FALSE(mentions(result.status, "open"));
    EXPECT_NEAR(result.hull->moments.volume, 1, rounding);
}

TEST(MakeHull, DisplacesOnceWhatIsThereTwice) {
    const HullResult result = makeHull({joined(unitBox, unitBox), boxMesh({1, 1, 1}, {3, 0, 0})});
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.status.duplicateTriangles, 12u);
    EXPECT_EQ(result.status.overlappingPairs, 0u);
    EXPECT_TRUE(mentions(result.status, "12 repeated triangles taken out"));
    EXPECT_NEAR(result.hull->moments.volume, 2, rounding);
    EXPECT_NEAR(result.hull->surfaceArea, 12, rounding);
    EXPECT_TRUE(result.hull->meshIsClosed);
}

TEST(MakeHull, SumsTheRemarksOfItsParts) {
    const TriangleMesh open = without(unitBox, 10, 2), flipped = inverted(boxMesh({1, 1, 1}, {3, 0, 0}));
    const HullResult result = makeHull({open, flipped, soup(boxMesh({1, 1, 1}, {6, 0, 0}))});
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.status.openEdges, 4u);
    EXPECT_EQ(result.status.flippedTriangles, 12u);
    EXPECT_EQ(result.status.weldedVertices, 28u);
    EXPECT_FALSE(result.hull->meshIsClosed);
    EXPECT_TRUE(mentions(result.status, "4 open edges"));
}

TEST(MakeHull, RefusesNothingToWet) {
    expectRefused(makeHull(std::vector<HullPart>{}), HullError::noTriangles);
    expectRefused(makeHull(TriangleMesh{}), HullError::noTriangles);
    expectRefused(makeHull(TriangleMesh{unitBox.vertices, {}}), HullError::noTriangles);
    expectRefused(makeHull(TriangleMesh{unitBox.vertices, {{1, 1, 2}}}), HullError::noTriangles);
    EXPECT_TRUE(mentions(makeHull(TriangleMesh{}).status, "nothing to wet"));
}

TEST(MakeHull, RefusesOneBadPartAmongGoodOnes) {
    expectRefused(makeHull({unitBox, TriangleMesh{}}), HullError::noTriangles);
    expectRefused(makeHull({Sphere{Vec3::Zero(), 0}, unitBox}), HullError::noVolume);
    expectRefused(makeHull({unitBox, Sphere{{nan, 0, 0}, 1}, unitBox}), HullError::notFinite);
}

TEST(MakeHull, RefusesIndicesOutOfRange) {
    TriangleMesh mesh = unitBox;
    mesh.triangles[3][1] = 8;
    expectRefused(makeHull(mesh), HullError::badIndices);
    EXPECT_TRUE(mentions(makeHull(mesh).status, "vertex that does not exist"));
}

TEST(MakeHull, RefusesWhatIsNotFinite) {
    for (double bad : {nan, infinity, -infinity}) {
        TriangleMesh mesh = unitBox;
        mesh.vertices[2].y() = bad;
        expectRefused(makeHull(mesh), HullError::notFinite);
        EXPECT_TRUE(mentions(makeHull(mesh).status, "not finite"));
        expectRefused(make(Sphere{{bad, 0, 0}, 1}), HullError::notFinite);
        expectRefused(make(makeCylinder({0, bad, 0}, Vec3::UnitZ(), 1, 1)), HullError::notFinite);
    }
    expectRefused(make(Sphere{Vec3::Zero(), nan}), HullError::notFinite);
    expectRefused(make(makeCylinder(Vec3::Zero(), Vec3::UnitZ(), nan, 1)), HullError::notFinite);
    expectRefused(make(makeCone(Vec3::Zero(), Vec3::UnitZ(), 1, infinity)), HullError::notFinite);
}

TEST(MakeHull, RefusesSurfacesThatEncloseNothing) {
    const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const TriangleMesh turnedSheet = moved(sheet, {random.inCube(10), random.orientation()});
        expectRefused(makeHull(turnedSheet), HullError::noVolume);
        expectRefused(makeHull(joined(turnedSheet, inverted(turnedSheet))), HullError::noVolume);
    }
    EXPECT_TRUE(mentions(makeHull(sheet).status, "encloses no volume"));
    // So far away that the mean of equal coordinates is another one.
    TriangleMesh pressed = tessellate(Sphere{Vec3::Zero(), 1}, 1);
    for (Vec3& vertex : pressed.vertices)
        vertex.z() = 6.9e28;
    expectRefused(makeHull(pressed), HullError::noVolume);
    expectRefused(make(Sphere{Vec3::Zero(), 0}), HullError::noVolume);
    expectRefused(make(Sphere{Vec3::Zero(), -1}), HullError::noVolume);
    expectRefused(make(makeCylinder(Vec3::Zero(), Vec3::UnitZ(), 0, 1)), HullError::noVolume);
    expectRefused(make(makeCylinder(Vec3::Zero(), Vec3::UnitZ(), 1, 0)), HullError::noVolume);
}

/// A thin box with a corner of one triangle drawn far away: what it encloses is told about its vertices'
/// mean.
TEST(MakeHull, TurnsOpenMeshesOutwardAboutTheirMean) {
    TriangleMesh thin = boxMesh({0.16, 3, 2.3});
    thin.vertices.push_back({-1.8, 2.4, 1.3});
    for (std::size_t triangle = 0; triangle < 12; ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            TriangleMesh mesh = thin;
            mesh.triangles[triangle][corner] = 8;
            const HullResult a = makeHull(mesh), b = makeHull(inverted(mesh));
            ASSERT_TRUE(a.hull && b.hull);
            EXPECT_FALSE(a.hull->meshIsClosed);
            EXPECT_GT(a.hull->moments.volume, 0);
            EXPECT_NEAR(a.hull->moments.volume, b.hull->moments.volume, rounding);
        }
}

/// Sheets, and a triangle that encloses less than nothing with their mean.
TEST(MakeHull, RefusesWhatEnclosesLessThanNothing) {
    TriangleMesh mesh = without(unitBox, 2, 1);
    mesh.vertices.front() = mesh.vertices.back();
    const HullResult result = makeHull(mesh);
    expectRefused(result, HullError::noVolume);
    EXPECT_GT(result.status.openEdges, 0u);
}

/// Two boxes, each half within the other: neither is a cavity of the other, however they face.
TEST(MakeHull, TurnsBothOfTwoSolidsThatCrossOutward) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{random.inCube(3), random.orientation()};
        const TriangleMesh crossing = boxMesh({0.8, 0.8, 0.8}, {0, 0, 0.5});
        const HullResult result = makeHull(moved(joined(inverted(unitBox), crossing), pose));
        ASSERT_TRUE(result.hull);
        EXPECT_NEAR(result.hull->moments.volume, 1 + 0.8 * 0.8 * 0.8, 10 * rounding);
    }
}

TEST(MakeHull, TakesWhatIsThinButSolid) {
    // A plank of 1 mm on 10 m, a hundred thousand times above what counts as a sheet, and a wire as thin.
    EXPECT_TRUE(makeHull(boxMesh({10, 1, 1e-3})).hull);
    EXPECT_TRUE(makeHull(boxMesh({10, 1e-2, 1e-3})).hull);
}

TEST(MakeHull, TakesHugeAndTinySolids) {
    for (double size : {1e-30, 1e-6, 1e6, 1e30}) {
        const HullResult box = makeHull(boxMesh(Vec3::Constant(size), {size, 0, 0}));
        ASSERT_TRUE(box.hull) << size;
        EXPECT_NEAR(box.hull->moments.volume / std::pow(size, 3), 1, rounding) << size;
        EXPECT_TRUE(isNear(box.hull->moments.centroid() / size, Vec3::UnitX(), rounding)) << size;
        const HullResult ball = make(Sphere{Vec3::Zero(), size});
        ASSERT_TRUE(ball.hull) << size;
        EXPECT_NEAR(ball.hull->moments.volume / std::pow(size, 3), 4 * pi / 3, rounding) << size;
    }
}

TEST(MakeHull, RefusesWhatOverflows) {
    // The volume of 1e110 m cubed is above 1.8e308 m^3; so are the first moment of 1e80 m and the second of
    // 1e65 m.
    for (double size : {1e65, 1e80, 1e110, 1e200, 1e300}) {
        expectRefused(makeHull(boxMesh(Vec3::Constant(size), {size, 0, 0})), HullError::notFinite);
        expectRefused(make(Sphere{{size, 0, 0}, size}), HullError::notFinite);
        expectRefused(make(makeCylinder({size, 0, 0}, Vec3::UnitZ(), size, size)), HullError::notFinite);
    }
}

TEST(MakeHull, NotesPartsThatOverlap) {
    const HullResult result = makeHull({unitBox, boxMesh({1, 1, 1}, {0.5, 0, 0}), Sphere{{9, 0, 0}, 1}});
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.status.overlappingPairs, 1u);
    EXPECT_NEAR(result.status.overlapVolume, 0.5, 0.01);
    EXPECT_NEAR(result.hull->moments.volume, 2 + 4 * pi / 3, rounding) << "each part counts";
    EXPECT_TRUE(mentions(result.status, "1 pairs of parts overlap"));
    EXPECT_TRUE(mentions(result.status, "displaced twice"));
}

TEST(MakeHull, CountsEveryPairThatOverlaps) {
    const Sphere ball{Vec3::Zero(), 0.3};
    const SolidOfRevolution rod = makeCylinder(Vec3::Zero(), Vec3::UnitX(), 0.1, 2);
    const HullResult result = makeHull({unitBox, ball, rod});
    EXPECT_EQ(result.status.overlappingPairs, 3u);
    const double ballInBox = 4 * pi / 3 * 0.027, rodInBox = pi * 0.01;
    // The rod's piece of the ball: a cylinder of the chord's length and two caps.
    const double half = std::sqrt(0.09 - 0.01), cap = 0.3 - half;
    const double rodInBall = pi * 0.01 * 2 * half + 2 * pi * cap * cap * (0.3 - cap / 3);
    // 1 % of each common bounding box, and what the rough mesh of the ball lacks: 0.9 %.
    const double tolerance = 0.01 * (0.216 + 0.04 + 0.024) + 0.009 * ballInBox;
    EXPECT_NEAR(result.status.overlapVolume, ballInBox + rodInBox + rodInBall, tolerance);
}

TEST(MakeHull, DoesNotNoteBoxesThatTouch) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{random.inCube(3), random.orientation()};
        const HullResult result =
            makeHull({moved(unitBox, pose), moved(boxMesh({1, 2, 1}, {1, 0.5, 0}), pose)});
        ASSERT_TRUE(result.hull);
        EXPECT_EQ(result.status.overlappingPairs, 0u);
        EXPECT_EQ(result.status.overlapVolume, 0);
        EXPECT_EQ(result.status.describe(), "ok");
    }
}

TEST(MakeHull, MakesTheSameHullOfASolidInAnyOrder) {
    Random random(4);
    for (const auto& [name, hull] : polyhedra())
        for (int i = 0; i < 10; ++i) {
            const HullResult other = makeHull(shuffled(hull->mesh, random));
            ASSERT_TRUE(other.hull) << name;
            EXPECT_NEAR(other.hull->moments.volume, hull->moments.volume, rounding) << name;
            EXPECT_TRUE(isNear(other.hull->moments.firstMoment, hull->moments.firstMoment, rounding)) << name;
            EXPECT_NEAR(other.hull->surfaceArea, hull->surfaceArea, 10 * rounding) << name;
            EXPECT_EQ(other.status.openEdges + other.status.flippedTriangles, 0u) << name;
        }
}

TEST(HullStatus, DescribesARefusalInAFewWords) {
    for (HullError error : {HullError::noTriangles, HullError::badIndices, HullError::notFinite,
                            HullError::flatPoints, HullError::noVolume}) {
        HullStatus status;
        status.error = error;
        status.openEdges = 5;
        EXPECT_FALSE(status.accepted());
        EXPECT_GT(status.describe().size(), 10u);
        EXPECT_FALSE(mentions(status, "ok"));
        EXPECT_FALSE(mentions(status, "open edges")) << "remarks are for what was accepted";
    }
    HullStatus status;
    status.error = HullError::unsupportedShape;
    status.reason = "a plane has no volume";
    EXPECT_EQ(status.describe(), "a plane has no volume");
}

TEST(HullStatus, DescribesTessellation) {
    HullStatus status;
    EXPECT_EQ(status.describe(), "ok");
    status.tessellationError = 0.0021;
    EXPECT_TRUE(mentions(status, "0.0021 of the volume uncertain by tessellation"));
}

TEST(Placed, IsScaledTurnedAndMoved) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{random.inCube(3), random.orientation()};
        const double scale = random.uniform(0.5, 2) * (random.coin() ? 1 : -1);  // below 0: mirrored
        const auto place = [&](const Vec3& p) {
            return Vec3(pose.position + pose.orientation * (scale * p));
        };

        const auto mesh = std::get<TriangleMesh>(placed(unitBox, pose, scale));
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            EXPECT_TRUE(isNear(mesh.vertices[v], place(unitBox.vertices[v]), rounding));
        EXPECT_EQ(mesh.triangles, unitBox.triangles);

        const auto sphere = std::get<Sphere>(placed(Sphere{{1, 2, 3}, 0.5}, pose, scale));
        EXPECT_TRUE(isNear(sphere.centre, place({1, 2, 3}), rounding));
        EXPECT_DOUBLE_EQ(sphere.radius, 0.5 * std::abs(scale));

        const SolidOfRevolution cone = makeCone({1, 2, 3}, Vec3::UnitY(), 0.5, 1);
        const auto solid = std::get<SolidOfRevolution>(placed(cone, pose, scale));
        const VolumeMoments before = volumeMoments(cone), after = volumeMoments(solid);
        EXPECT_NEAR(after.volume, std::pow(std::abs(scale), 3) * before.volume, rounding);
        EXPECT_TRUE(isNear(after.centroid(), place(before.centroid()), rounding));
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
