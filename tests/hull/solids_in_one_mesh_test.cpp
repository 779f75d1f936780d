#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/closed_solids.h"
#include "bullet_buoyancy/hull/find_overlaps.h"
#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/hull/mesh_repair.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

/// The columns through aligned boxes sum their lengths: some 4,096 additions.
constexpr double rounding = 4096 * epsilon;

const TriangleMesh unitBox = boxMesh({1, 1, 1});

TriangleMesh cube(double size, const Vec3& centre = Vec3::Zero()) {
    return boxMesh(Vec3::Constant(size), centre);
}

TriangleMesh allOf(const std::vector<TriangleMesh>& meshes) {
    TriangleMesh all;
    for (const TriangleMesh& mesh : meshes)
        all = joined(all, mesh);
    return all;
}

std::vector<TriangleMesh> solidsOf(TriangleMesh mesh) {
    const MeshFindings findings = repairMesh(mesh);
    return closedSolids(mesh, findings.shells);
}

HullStatus accepted(const TriangleMesh& mesh) {
    const HullResult result = makeHull(mesh);
    EXPECT_TRUE(result.hull);
    return result.status;
}

void expectNoOverlap(const TriangleMesh& mesh) {
    const HullStatus status = accepted(mesh);
    EXPECT_EQ(status.overlappingPairs, 0u);
    EXPECT_EQ(status.overlapVolume, 0);
    EXPECT_EQ(status.uncheckedPairs, 0u);
}

void expectOverlap(const TriangleMesh& mesh, std::size_t pairs, double volume) {
    const HullStatus status = accepted(mesh);
    EXPECT_EQ(status.overlappingPairs, pairs);
    EXPECT_NEAR(status.overlapVolume, volume, rounding);
}

TEST(SolidsInOneMesh, ThatCrossAreNotedAsPartsAre) {
    const TriangleMesh other = boxMesh({1, 1, 1}, {0.5, 0, 0});
    const HullResult one = makeHull(joined(unitBox, other)), parts = makeHull({unitBox, other});
    ASSERT_TRUE(one.hull);
    EXPECT_EQ(one.status.overlappingPairs, 1u);
    EXPECT_NEAR(one.status.overlapVolume, 0.5, rounding);
    EXPECT_EQ(one.status.describe(), parts.status.describe());
    EXPECT_NE(one.status.describe().find("1 pairs of parts overlap"), std::string::npos);
    EXPECT_NEAR(one.hull->moments.volume, 2, rounding) << "each counts";
}

TEST(SolidsInOneMesh, ThatCrossAreNotedAnyWayRound) {
    Random random(1);
    const TriangleMesh other = boxMesh({1, 1, 1}, {0.75, 0.1, 0.2});
    for (int i = 0; i < 20; ++i) {
        const Pose pose{random.inCube(1), random.orientation()};
        const TriangleMesh both = joined(unitBox, i % 2 ? inverted(other) : other);
        const HullStatus status = accepted(shuffled(moved(both, pose), random));
        EXPECT_EQ(status.flippedTriangles, i % 2 ? 12u : 0u);
        EXPECT_EQ(status.overlappingPairs, 1u);
        // 1 % of the space that both bounding boxes cover: at most that of a box's, 3 sqrt 3 m^3.
        EXPECT_NEAR(status.overlapVolume, 0.25 * 0.9 * 0.8, 0.052);
    }
}

TEST(SolidsInOneMesh, OneWithinAnotherFacingTheSameWayIsDisplacedTwice) {
    const TriangleMesh nested = joined(unitBox, cube(0.5, {0.1, 0, 0}));
    expectOverlap(nested, 1, 0.125);
    expectOverlap(inverted(nested), 1, 0.125);
}

TEST(SolidsInOneMesh, ACavityIsNoOverlap) {
    const TriangleMesh hollow = joined(unitBox, inverted(cube(0.5, {0.1, 0, 0})));
    expectNoOverlap(hollow);
    expectNoOverlap(inverted(hollow));
    ASSERT_EQ(solidsOf(hollow).size(), 1u);
    EXPECT_NEAR(volumeMoments(solidsOf(hollow)[0]).volume, 0.875, rounding);
}

TEST(SolidsInOneMesh, WhatStandsInACavityIsNoOverlap) {
    Random random(2);
    const TriangleMesh nest = allOf({unitBox, inverted(cube(0.8)), cube(0.6), inverted(cube(0.4)),
                                     cube(0.1, {0.1, 0, 0}), cube(0.1, {-0.1, 0, 0})});
    for (int i = 0; i < 20; ++i) {
        const TriangleMesh mesh = shuffled(i % 2 ? nest : inverted(nest), random);
        expectNoOverlap(mesh);
        EXPECT_EQ(solidsOf(mesh).size(), 4u);
    }
}

TEST(SolidsInOneMesh, WhatReachesFromACavityIntoTheWallOverlapsThere) {
    const TriangleMesh hollow = joined(unitBox, inverted(cube(0.6)));
    // From the cavity's bottom at -0.3 m up through the wall of 0.2 m, by 0.1 m.
    expectOverlap(joined(hollow, boxMesh({0.2, 0.2, 0.5}, {0.05, 0, 0.15})), 1, 0.2 * 0.2 * 0.1);
}

TEST(SolidsInOneMesh, ApartAreNotRemarked) {
    TriangleMesh grid;
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
            for (int z = 0; z < 5; ++z)
                grid = joined(grid, cube(1, 1.01 * Vec3(x, y, z)));
    EXPECT_EQ(solidsOf(grid).size(), 125u);
    EXPECT_EQ(accepted(grid).describe(), "ok");

    const TriangleMesh ring = ringMesh(0.3, 0.6, 0.1, 12);
    EXPECT_EQ(accepted(ring).describe(), "ok");
    EXPECT_EQ(accepted(joined(ring, boxMesh({0.3, 0.3, 2}))).describe(), "ok") << "post through a ring";
    const Pose across{{0.45, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(pi / 2, Vec3::UnitX()))};
    EXPECT_EQ(accepted(joined(ring, moved(ring, across))).describe(), "ok") << "two links of a chain";
}

TEST(SolidsInOneMesh, ThatTouchAreNotRemarked) {
    for (const Vec3& at : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
        expectNoOverlap(joined(unitBox, cube(1, at)));
    }
    expectNoOverlap(joined(unitBox, inverted(cube(1, {1, 1, 0}))));
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{random.inCube(1), random.orientation()};
        TriangleMesh mesh = moved(joined(unitBox, boxMesh({1, 2, 1}, {1, 0.3, 0.1})), pose);
        for (Vec3& vertex : mesh.vertices)
            vertex = throughFloat(vertex);
        EXPECT_EQ(accepted(mesh).describe(), "ok");
    }
}

TEST(SolidsInOneMesh, OpenAndFlatShellsAreNone) {
    const TriangleMesh other = boxMesh({1, 1, 1}, {0.5, 0, 0});
    EXPECT_EQ(solidsOf(joined(unitBox, without(other, 10, 2))).size(), 1u);
    const TriangleMesh sheet = without(other, 2, 10);
    EXPECT_EQ(solidsOf(allOf({unitBox, sheet, inverted(sheet)})).size(), 1u);
    expectNoOverlap(allOf({unitBox, sheet, inverted(sheet)}));
}

TEST(SolidsInOneMesh, AreCheckedUpToAThousandPairs) {
    TriangleMesh many;
    for (int i = 0; i < 50; ++i)
        many = joined(many, cube(1, 0.01 * i * Vec3(1, 0.9, 0.8)));
    const HullStatus status = accepted(many);
    EXPECT_EQ(status.overlappingPairs, 1000u);
    EXPECT_EQ(status.uncheckedPairs, 50u * 49 / 2 - 1000);
    EXPECT_NE(status.describe().find("225 pairs of solids in one mesh not checked"), std::string::npos);
}

TEST(FindOverlaps, MeasuresThosePairsThatHaveTheMostRoomInCommon) {
    const std::vector<TriangleMesh> row{cube(1), cube(1, {0.9, 0, 0}), cube(1, {1.5, 0, 0})};
    const Overlaps all = findOverlaps(row, 3);
    EXPECT_EQ(all.pairs, 2u);
    EXPECT_NEAR(all.volume, 0.1 + 0.4, rounding);
    EXPECT_EQ(all.uncheckedPairs, 0u);
    const Overlaps one = findOverlaps(row, 1);
    EXPECT_EQ(one.pairs, 1u);
    EXPECT_NEAR(one.volume, 0.4, rounding);
    EXPECT_EQ(one.uncheckedPairs, 1u);
    EXPECT_EQ(findOverlaps({}, 1).pairs, 0u);
}

}  // namespace
}  // namespace bullet_buoyancy::test
