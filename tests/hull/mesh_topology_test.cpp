#include <gtest/gtest.h>

#include <limits>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/convex_hull.h"
#include "bullet_buoyancy/hull/mesh_edges.h"
#include "bullet_buoyancy/hull/mesh_repair.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hull/volume_moments.h"
#include "bullet_buoyancy/hull/weld.h"
#include "bullet_buoyancy/hull/winding_number.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

/// Volumes of meshes of about 1 m and a few hundred triangles: each tetrahedron rounds some ten times.
constexpr double roundingOfVolume = 1000 * epsilon;

const TriangleMesh unitBox = boxMesh({1, 1, 1});

TriangleMesh icosphere(double radius = 0.5, const Vec3& centre = Vec3::Zero()) {
    return tessellate(Sphere{centre, radius}, 2);
}

/// A strip round z with a half twist.
TriangleMesh moebiusStrip(std::uint32_t segments) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < segments; ++i) {
        const double angle = 2 * pi * i / segments;
        const Vec3 radial(std::cos(angle), std::sin(angle), 0);
        const Vec3 across = std::cos(angle / 2) * radial + std::sin(angle / 2) * Vec3::UnitZ();
        mesh.vertices.push_back(radial - 0.2 * across);
        mesh.vertices.push_back(radial + 0.2 * across);
    }
    for (std::uint32_t i = 0; i < segments; ++i) {
        const bool last = i + 1 == segments;
        const std::uint32_t low = 2 * i, high = 2 * i + 1;
        const std::uint32_t nextLow = last ? 1 : low + 2, nextHigh = last ? 0 : high + 2;
        mesh.triangles.push_back({low, nextLow, nextHigh});
        mesh.triangles.push_back({low, nextHigh, high});
    }
    return mesh;
}

void flipRandomTriangles(TriangleMesh& mesh, double share, Random& random) {
    for (Triangle& triangle : mesh.triangles)
        if (random.uniform(0, 1) < share) triangle = turned(triangle);
}

TEST(Weld, MakesOneVertexOfExactRepeats) {
    TriangleMesh mesh = soup(unitBox);
    const WeldCounts counts = weld(mesh, 0);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(counts.removedVertices, 28u);
    EXPECT_EQ(counts.removedTriangles, 0u);
    EXPECT_EQ(countOpenEdges(mesh), 0u);
    EXPECT_NEAR(volumeMoments(mesh).volume, 1, roundingOfVolume);
}

TEST(Weld, LeavesEveryCornerWhereItWas) {
    Random random(1);
    const TriangleMesh before = soup(shuffled(icosphere(), random));
    TriangleMesh mesh = before;
    weld(mesh, 1e-9);
    ASSERT_EQ(mesh.triangles.size(), before.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(mesh.vertices[mesh.triangles[t][i]], before.vertices[before.triangles[t][i]]);
}

TEST(Weld, MergesWithinTheToleranceOnly) {
    const double tolerance = 1e-3;
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = i < 3 ? Vec3(Vec3::Unit(i)) : random.direction();
        for (const auto& [distance, vertices] :
             {std::pair(0.999 * tolerance, 4u), std::pair(1.001 * tolerance, 5u)}) {
            // Two triangles that nearly share an edge: of four corners there, two pairs; one pair is exact.
            TriangleMesh mesh{{{0, 0, 0},
                               {1, 0, 0},
                               {0.5, 1, 0},
                               {0, 0, 0},
                               Vec3(1, 0, 0) + distance * direction,
                               {0.5, -1, 0}},
                              {{0, 1, 2}, {4, 3, 5}}};
            EXPECT_EQ(weld(mesh, tolerance).removedVertices, 6 - vertices) << direction.transpose();
            EXPECT_EQ(mesh.vertices.size(), vertices) << direction.transpose();
        }
    }
}

TEST(Weld, TakesOutVerticesThatNoTriangleUses) {
    TriangleMesh mesh = unitBox;
    mesh.vertices.insert(mesh.vertices.begin(), {5, 5, 5});
    mesh.vertices.push_back({-5, 5, 5});
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle)
            ++corner;
    EXPECT_EQ(weld(mesh, 1e-6).removedVertices, 2u);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_NEAR(volumeMoments(mesh).volume, 1, roundingOfVolume);
}

TEST(Weld, CountsTrianglesThatCollapse) {
    TriangleMesh mesh = unitBox;
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({2, 2, 2});
    mesh.vertices.push_back(mesh.vertices[3] + Vec3(1e-9, 0, 0));
    mesh.triangles.push_back({3, 8, 7});
    const WeldCounts counts = weld(mesh, 1e-8);
    EXPECT_EQ(counts.removedTriangles, 3u);
    EXPECT_EQ(counts.removedVertices, 1u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(countOpenEdges(mesh), 0u);
}

TEST(Weld, OfNothingIsNothing) {
    TriangleMesh mesh;
    const WeldCounts counts = weld(mesh, 1);
    EXPECT_EQ(counts.removedVertices, 0u);
    EXPECT_EQ(counts.removedTriangles, 0u);
}

TEST(CountOpenEdges, CountsTriangleSidesThatNothingBalances) {
    EXPECT_EQ(countOpenEdges({}), 0u);
    EXPECT_EQ(countOpenEdges(unitBox), 0u);
    EXPECT_EQ(countOpenEdges(ringMesh(0.3, 0.6, 0.2, 12)), 0u);
    EXPECT_EQ(countOpenEdges(without(unitBox, 0, 1)), 3u) << "a triangle is missing";
    EXPECT_EQ(countOpenEdges(without(unitBox, 0, 2)), 4u) << "a face is missing";
    EXPECT_EQ(countOpenEdges(without(unitBox, 1, 11)), 3u) << "a single triangle";
    EXPECT_EQ(countOpenEdges(soup(unitBox)), 36u) << "nothing hangs together";
}

TEST(CountOpenEdges, CountsBothSidesOfAnEdgeThatRunTheSameWay) {
    TriangleMesh mesh = unitBox;
    mesh.triangles[5] = turned(mesh.triangles[5]);
    EXPECT_EQ(countOpenEdges(mesh), 6u);
}

TEST(CountOpenEdges, BalancesFourSidesAtAnEdgeWhereTwoSolidsTouch) {
    TriangleMesh mesh = joined(unitBox, boxMesh({1, 1, 1}, {1, 1, 0}));
    weld(mesh, 1e-9);
    EXPECT_EQ(mesh.vertices.size(), 14u);
    EXPECT_EQ(countOpenEdges(mesh), 0u);
}

TEST(RepairMesh, LeavesAGoodMeshAlone) {
    for (const TriangleMesh& good : {unitBox, icosphere(), ringMesh(0.3, 0.6, 0.2, 12)}) {
        TriangleMesh mesh = good;
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.error, HullError::none);
        EXPECT_EQ(findings.weldedVertices + findings.degenerateTriangles, 0u);
        EXPECT_EQ(findings.flippedTriangles, 0u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_EQ(mesh.triangles.size(), good.triangles.size());
        EXPECT_NEAR(volumeMoments(mesh).volume, volumeMoments(good).volume, roundingOfVolume);
    }
}

TEST(RepairMesh, TurnsAnInvertedMeshOutward) {
    TriangleMesh mesh = inverted(unitBox);
    const MeshFindings findings = repairMesh(mesh);
    EXPECT_EQ(findings.flippedTriangles, 12u);
    EXPECT_EQ(findings.openEdges, 0u);
    EXPECT_NEAR(volumeMoments(mesh).volume, 1, roundingOfVolume);
}

TEST(RepairMesh, TurnsASingleFlippedTriangle) {
    const TriangleMesh good = icosphere();
    for (std::size_t t = 0; t < good.triangles.size(); ++t) {
        TriangleMesh mesh = good;
        mesh.triangles[t] = turned(mesh.triangles[t]);
        EXPECT_EQ(repairMesh(mesh).flippedTriangles, 1u);
        EXPECT_EQ(countOpenEdges(mesh), 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, volumeMoments(good).volume, roundingOfVolume);
    }
}

TEST(RepairMesh, RepairsAnySubsetOfFlippedTriangles) {
    Random random(3);
    TriangleMesh good = icosphere();
    repairMesh(good);  // which orders the vertices
    for (int i = 0; i < 500; ++i) {
        TriangleMesh mesh = good;
        flipRandomTriangles(mesh, random.uniform(0, 1), random);
        EXPECT_EQ(repairMesh(mesh).openEdges, 0u);
        ASSERT_EQ(mesh.triangles.size(), good.triangles.size());
        EXPECT_NEAR(volumeMoments(mesh).volume, volumeMoments(good).volume, roundingOfVolume);
    }
}

TEST(RepairMesh, CountsHowManyTrianglesItTurned) {
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        TriangleMesh mesh = icosphere();
        std::size_t flipped = 0;
        for (Triangle& triangle : mesh.triangles)
            if (random.coin()) {
                triangle = turned(triangle);
                ++flipped;
            }
        EXPECT_EQ(repairMesh(mesh).flippedTriangles, flipped);
    }
}

TEST(RepairMesh, IsDoneAfterOnce) {
    Random random(5);
    TriangleMesh mesh = soup(joined(icosphere(), boxMesh({0.1, 0.2, 0.3})));
    flipRandomTriangles(mesh, 0.3, random);
    repairMesh(mesh);
    const MeshFindings again = repairMesh(mesh);
    EXPECT_EQ(again.duplicateTriangles, 0u);
    EXPECT_EQ(again.weldedVertices + again.degenerateTriangles + again.flippedTriangles + again.openEdges,
              0u);
}

TEST(RepairMesh, KeepsACavityACavity) {
    const double cavity = volumeMoments(icosphere(0.2)).volume;
    const TriangleMesh good = joined(unitBox, inverted(icosphere(0.2, {0.1, 0, -0.2})));
    for (const TriangleMesh& start : {good, inverted(good)}) {
        TriangleMesh mesh = start;
        repairMesh(mesh);
        EXPECT_EQ(countOpenEdges(mesh), 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 1 - cavity, roundingOfVolume);
    }
}

TEST(RepairMesh, KeepsAnIslandInACavitySolid) {
    const double shell = std::pow(0.8, 3), island = std::pow(0.3, 3);
    TriangleMesh mesh = joined(joined(unitBox, inverted(boxMesh({0.8, 0.8, 0.8}))), boxMesh({0.3, 0.3, 0.3}));
    mesh = inverted(mesh);
    repairMesh(mesh);
    EXPECT_NEAR(volumeMoments(mesh).volume, 1 - shell + island, roundingOfVolume);
}

TEST(RepairMesh, TurnsOnlyTheInvertedOneOfTwoSolids) {
    const double ball = volumeMoments(icosphere(0.3)).volume;
    for (const Vec3& place :
         {Vec3(2, 0, 0), Vec3(0, 0.4, 0.9)}) {  // apart, and with overlapping bounding boxes
        TriangleMesh mesh = joined(unitBox, inverted(icosphere(0.3, place)));
        EXPECT_EQ(repairMesh(mesh).flippedTriangles, 320u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 1 + ball, roundingOfVolume);
    }
}

TEST(RepairMesh, KeepsSolidsThatTouchFaceToFaceInOneMesh) {
    // Stacked boxes share the four edges of a face, where four triangles meet: the surface falls apart into
    // open boxes and flat patches there. Any way round, in any position, the two boxes must come out.
    Random random(6);
    for (int i = 0; i < 300; ++i) {
        const Pose pose{random.inCube(1), random.orientation()};
        const TriangleMesh stack = moved(joined(boxMesh({1, 1, 1}), boxMesh({1, 1, 2}, {0, 0, 1.5})), pose);
        TriangleMesh mesh = shuffled(i % 2 ? stack : inverted(stack), random);
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.weldedVertices, 4u);
        EXPECT_EQ(findings.flippedTriangles, i % 2 ? 0u : 24u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 3, roundingOfVolume);
    }
}

TEST(RepairMesh, TurnsASingleFlippedTriangleOfSolidsThatTouchFaceToFace) {
    const TriangleMesh stack = joined(boxMesh({1, 1, 1}), boxMesh({1, 1, 2}, {0, 0, 1.5}));
    for (std::size_t t = 0; t < stack.triangles.size(); ++t) {
        TriangleMesh mesh = stack;
        mesh.triangles[t] = turned(mesh.triangles[t]);
        EXPECT_EQ(repairMesh(mesh).openEdges, 0u) << t;
        EXPECT_NEAR(volumeMoments(mesh).volume, 3, roundingOfVolume) << t;
    }
}

TEST(RepairMesh, KeepsADentThatMeetsTheRestAtSeams) {
    // A fin on the rim of a recess joins four triangles at an edge of it all round: by itself the recess
    // would be a surface that bulges the other way.
    TriangleMesh mesh = without(unitBox, 10, 2);  // top
    const std::uint32_t bottomOfRecess = 8;
    mesh.vertices.push_back({0, 0, -0.2});
    for (const auto& [from, to] :
         {std::pair(1u, 5u), std::pair(5u, 7u), std::pair(7u, 3u), std::pair(3u, 1u)}) {
        mesh.triangles.push_back({from, to, bottomOfRecess});
        const auto outer = std::uint32_t(mesh.vertices.size());
        mesh.vertices.push_back((mesh.vertices[from] + mesh.vertices[to]) / 2 + Vec3(0, 0, 0.3));
        mesh.triangles.push_back({from, to, outer});
        mesh.triangles.push_back({to, from, outer});
    }
    ASSERT_EQ(countOpenEdges(mesh), 0u);
    const double volume = 1 - 0.7 / 3;
    for (const TriangleMesh& start : {mesh, inverted(mesh)}) {
        TriangleMesh repaired = start;
        EXPECT_EQ(repairMesh(repaired).openEdges, 0u);
        EXPECT_NEAR(volumeMoments(repaired).volume, volume, roundingOfVolume);
    }
}

TEST(RepairMesh, TurnsTheInvertedOneOfTwoSolidsThatTouchFaceToFace) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const Pose pose{random.inCube(1), random.orientation()};
        const TriangleMesh large = boxMesh({1, 1, 1}), small = boxMesh({0.5, 0.4, 0.3}, {0.1, 0, 0.65});
        const TriangleMesh both = i % 2 ? joined(inverted(large), small) : joined(large, inverted(small));
        TriangleMesh mesh = shuffled(moved(both, pose), random);
        EXPECT_EQ(repairMesh(mesh).flippedTriangles, 12u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 1.06, roundingOfVolume);
    }
}

TEST(RepairMesh, TakesOutATriangleThatIsThereTwice) {
    Random random(8);
    const double volume = volumeMoments(icosphere()).volume;
    for (int i = 0; i < 300; ++i) {
        TriangleMesh mesh = moved(icosphere(), {random.inCube(1), random.orientation()});
        mesh.triangles.push_back(mesh.triangles[random.index(mesh.triangles.size())]);
        const TriangleMesh start = i % 2 ? mesh : inverted(mesh);
        mesh = shuffled(start, random);
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.duplicateTriangles, 1u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_EQ(findings.flippedTriangles, i % 2 ? 0u : 320u);
        EXPECT_NEAR(volumeMoments(mesh).volume, volume, 10 * roundingOfVolume);
    }
}

TEST(RepairMesh, TakesOutAMeshThatIsThereTwiceOrThrice) {
    Random random(15);
    const TriangleMesh open = without(unitBox, 10, 2);
    for (const TriangleMesh& once : {unitBox, icosphere(), ringMesh(0.3, 0.6, 0.2, 12), open}) {
        const std::size_t openEdges = countOpenEdges(once), count = once.triangles.size();
        TriangleMesh alone = once;
        repairMesh(alone);
        for (const TriangleMesh& twice : {joined(once, once), joined(soup(once), soup(once)),
                                          joined(joined(once, once), once), inverted(joined(once, once))}) {
            TriangleMesh mesh = shuffled(twice, random);
            const MeshFindings findings = repairMesh(mesh);
            EXPECT_EQ(findings.duplicateTriangles, twice.triangles.size() - count);
            EXPECT_EQ(mesh.triangles.size(), count);
            EXPECT_EQ(findings.openEdges, openEdges);
            EXPECT_NEAR(volumeMoments(mesh).volume, volumeMoments(alone).volume, roundingOfVolume);
        }
    }
}

TEST(RepairMesh, TakesOutCopiesWhoseWindingDisagreesWithTheirNeighbours) {
    Random random(16);
    const double volume = volumeMoments(icosphere()).volume;
    for (int i = 0; i < 100; ++i) {
        TriangleMesh mesh = icosphere();
        flipRandomTriangles(mesh, random.uniform(0, 1), random);
        mesh = shuffled(joined(mesh, mesh), random);
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.duplicateTriangles, 320u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, volume, roundingOfVolume);
    }
}

TEST(RepairMesh, TakesOutACopyThatDisagreesWithItsOriginal) {
    const TriangleMesh twice = joined(unitBox, unitBox);
    for (std::size_t t = 0; t < twice.triangles.size(); ++t) {
        TriangleMesh mesh = twice;
        mesh.triangles[t] = turned(mesh.triangles[t]);
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.duplicateTriangles, 12u);
        EXPECT_EQ(findings.flippedTriangles, 1u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 1, roundingOfVolume);
    }
}

TEST(RepairMesh, LeavesTheTwoSidesOfASheet) {
    TriangleMesh sides = joined(unitBox, inverted(unitBox));
    EXPECT_EQ(repairMesh(sides).duplicateTriangles, 0u);
    EXPECT_EQ(sides.triangles.size(), 24u);
    EXPECT_NEAR(volumeMoments(sides).volume, 0, roundingOfVolume);

    // A fin of two sides stays, whether it stands at an edge or lies on a face.
    for (const Triangle& corners : {Triangle{0, 1, 8}, unitBox.triangles[0]}) {
        TriangleMesh mesh = unitBox;
        mesh.vertices.push_back({0, 0, -2});
        mesh.triangles.insert(mesh.triangles.end(), {corners, turned(corners)});
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.duplicateTriangles, 0u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 1, roundingOfVolume);
    }
}

TEST(RepairMesh, LeavesTheCommonFaceOfSolidsThatTouchThere) {
    // The face is there from either side; where one box is inside out, twice from the same.
    Random random(17);
    const TriangleMesh lower = boxMesh({1, 1, 1}), upper = boxMesh({1, 1, 1}, {0, 0, 1});
    TriangleMesh mirrored = upper;  // so that the common face is cut alike
    for (Vec3& vertex : mirrored.vertices)
        vertex.z() = 2 - vertex.z();
    mirrored = inverted(mirrored);
    for (const TriangleMesh& other : {upper, mirrored, inverted(mirrored)})
        for (int i = 0; i < 20; ++i) {
            TriangleMesh mesh = shuffled(joined(lower, other), random);
            const MeshFindings findings = repairMesh(mesh);
            EXPECT_EQ(findings.duplicateTriangles, 0u);
            EXPECT_EQ(findings.openEdges, 0u);
            EXPECT_EQ(mesh.triangles.size(), 24u);
        }
}

TEST(RepairMesh, TakesOutOneOfTwoSolidsThatTouchWhenItIsThereTwice) {
    Random random(18);
    const TriangleMesh lower = boxMesh({1, 1, 1}), upper = boxMesh({1, 1, 2}, {0, 0, 1.5});
    for (const TriangleMesh& twice : {lower, upper}) {
        TriangleMesh mesh = shuffled(joined(joined(lower, upper), twice), random);
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.duplicateTriangles, 12u);
        EXPECT_EQ(findings.openEdges, 0u);
        EXPECT_NEAR(volumeMoments(mesh).volume, 3, roundingOfVolume);
    }
}

TEST(RepairMesh, KeepsAnOpenBoxOutward) {
    const TriangleMesh open = without(unitBox, 10, 2);
    for (const TriangleMesh& start : {open, inverted(open)}) {
        TriangleMesh mesh = start;
        EXPECT_EQ(repairMesh(mesh).openEdges, 4u);
        // Towards the mean of the vertices a box without one face spans its volume less a pyramid under that
        // face.
        EXPECT_GT(volumeMoments(mesh).volume, 0.5);
    }
}

TEST(RepairMesh, AcceptsAMoebiusStripWithOpenEdges) {
    for (std::uint32_t segments : {5u, 12u, 51u}) {
        TriangleMesh mesh = moebiusStrip(segments);
        const MeshFindings findings = repairMesh(mesh);
        EXPECT_EQ(findings.error, HullError::none);
        // Its boundary, and at least one edge across along which the winding cannot agree.
        EXPECT_GE(findings.openEdges, 2 * segments + 2);
        EXPECT_EQ(mesh.triangles.size(), 2 * segments);
    }
}

TEST(RepairMesh, RefusesWhatIsNotFiniteAndLeavesItAsItWas) {
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (int axis = 0; axis < 3; ++axis) {
            TriangleMesh mesh = soup(inverted(unitBox));
            mesh.vertices.back()[axis] = bad;
            const std::vector<Triangle> before = mesh.triangles;
            EXPECT_EQ(repairMesh(mesh).error, HullError::notFinite);
            EXPECT_EQ(mesh.triangles, before);
            EXPECT_EQ(mesh.vertices.size(), 36u);
        }
}

TEST(RepairMesh, RefusesIndicesOutOfRange) {
    for (std::uint32_t bad : {8u, 1000u, std::numeric_limits<std::uint32_t>::max()})
        for (std::size_t corner = 0; corner < 3; ++corner) {
            TriangleMesh mesh = unitBox;
            mesh.triangles.back()[corner] = bad;
            EXPECT_EQ(repairMesh(mesh).error, HullError::badIndices);
        }
}

TEST(RepairMesh, WeldsWhatSinglePrecisionTearsApart) {
    // Every triangle's corners are moved by the rounding of single precision, each in its own way.
    Random random(9);
    const TriangleMesh good = icosphere(0.5, {3, 2, 1});
    TriangleMesh mesh = soup(good);
    for (Vec3& vertex : mesh.vertices)
        vertex = vertex.cwiseProduct(Vec3::Ones() + 0.3 * weldTolerance * random.inCube(1) / 4);
    const MeshFindings findings = repairMesh(mesh);
    EXPECT_EQ(findings.weldedVertices, 960u - 162u);
    EXPECT_EQ(findings.openEdges, 0u);
    // Corners have moved by up to 1e-7: the volume by that times the area of pi m^2.
    EXPECT_NEAR(volumeMoments(mesh).volume, volumeMoments(good).volume, pi * 1e-7);
}

TEST(MeshSize, IsTheDiagonalOfTheBoundingBox) {
    EXPECT_EQ(meshSize({}), 0);
    EXPECT_DOUBLE_EQ(meshSize(boxMesh({1, 2, 2}, {7, 8, 9})), 3);
}

TEST(VolumeMoments, OfABoxAreItsOwnWhereverItIs) {
    Random random(10);
    for (double distance : {0.0, 1.0, 1e6})
        for (int i = 0; i < 100; ++i) {
            const Pose pose{distance * random.direction(), random.orientation()};
            const VolumeMoments moments = volumeMoments(moved(boxMesh({2, 3, 5}), pose));
            // Far away the vertices themselves are rounded to epsilon of the distance, over an area of 62
            // m^2.
            EXPECT_NEAR(moments.volume, 30, 1000 * epsilon + 62 * epsilon * distance);
            EXPECT_TRUE(isNear(moments.centroid(), pose.position, 100 * epsilon * (1 + distance)));
        }
}

TEST(VolumeMoments, OfATetrahedronAreASixthOfTheTripleProduct) {
    Random random(11);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = random.inCube(1), b = random.inCube(1), c = random.inCube(1), d = random.inCube(1);
        const TriangleMesh mesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
        const double volume = (b - a).cross(c - a).dot(d - a) / 6;
        const VolumeMoments moments = volumeMoments(mesh);
        EXPECT_NEAR(moments.volume, volume, roundingOfVolume);
        EXPECT_TRUE(isNear(moments.firstMoment, volume * (a + b + c + d) / 4, roundingOfVolume));
    }
}

TEST(SurfaceArea, OfABoxIsThatOfItsFaces) {
    EXPECT_DOUBLE_EQ(surfaceArea(boxMesh({2, 3, 5}, {1, 1, 1})), 62);
    EXPECT_DOUBLE_EQ(surfaceArea(inverted(boxMesh({2, 3, 5}))), 62);
}

TEST(WindingNumber, IsOneInsideAndZeroOutside) {
    Random random(12);
    const TriangleMesh mesh = icosphere(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = random.direction();
        // The mesh lies between radii 0.95 and 1. Each of 320 angles rounds a few times, near the surface
        // more.
        EXPECT_NEAR(windingNumber(mesh, random.uniform(0, 0.9) * direction), 1, 1e4 * epsilon);
        EXPECT_NEAR(windingNumber(mesh, random.uniform(1.05, 9) * direction), 0, 1e4 * epsilon);
        EXPECT_NEAR(windingNumber(inverted(mesh), random.uniform(0, 0.9) * direction), -1, 1e4 * epsilon);
    }
}

TEST(WindingNumber, CountsNestedSurfaces) {
    const TriangleMesh twice = joined(boxMesh({2, 2, 2}), boxMesh({1, 1, 1}));
    EXPECT_NEAR(windingNumber(twice, {0.1, 0.2, 0.3}), 2, 100 * epsilon);
    EXPECT_NEAR(windingNumber(twice, {0.7, 0.2, 0.3}), 1, 100 * epsilon);
    const TriangleMesh cavity = joined(boxMesh({2, 2, 2}), inverted(boxMesh({1, 1, 1})));
    EXPECT_NEAR(windingNumber(cavity, {0.1, 0.2, 0.3}), 0, 100 * epsilon);
    EXPECT_NEAR(windingNumber(cavity, {0.7, 0.2, 0.3}), 1, 100 * epsilon);
}

TEST(WindingNumber, LosesAtTheCentreOfABoxASixthWithEachFace) {
    for (int faces = 0; faces <= 6; ++faces)
        EXPECT_NEAR(windingNumber(without(unitBox, 0, 2 * faces), Vec3::Zero()), 1 - faces / 6.0,
                    100 * epsilon);
}

}  // namespace
}  // namespace bullet_buoyancy::test
