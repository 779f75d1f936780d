#include "bullet_buoyancy/hull/overlap.h"

#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

/// The columns through aligned boxes sum their lengths: some 4,096 additions.
constexpr double rounding = 4096 * epsilon;

/// What the header promises, as a share of the space that both bounding boxes cover.
constexpr double promised = 0.01;

/// A quarter turn about z without rounding: the faces' diagonals then run the other way.
TriangleMesh quarterTurned(TriangleMesh mesh) {
    for (Vec3& vertex : mesh.vertices)
        vertex = Vec3(-vertex.y(), vertex.x(), vertex.z());
    return mesh;
}

TriangleMesh ball(double radius, const Vec3& centre) {
    return tessellate(Sphere{centre, radius}, 4);
}

TEST(OverlapVolume, IsZeroForSolidsApart) {
    const TriangleMesh box = boxMesh({1, 1, 1});
    EXPECT_EQ(overlapVolume(box, boxMesh({1, 1, 1}, {3, 0, 0})), 0);
    EXPECT_EQ(overlapVolume(box, boxMesh({1, 1, 1}, {1.01, 1.01, 1.01})), 0);
    EXPECT_EQ(overlapVolume({}, box), 0);
}

TEST(OverlapVolume, IsZeroForSolidsApartWhoseBoundingBoxesOverlap) {
    EXPECT_EQ(overlapVolume(boxMesh({1, 1, 1}), ball(0.5, {0.8, 0.8, 0.8})), 0) << "ball off a corner";
    const TriangleMesh ring = ringMesh(0.3, 0.6, 0.2, 12);
    EXPECT_EQ(overlapVolume(ring, boxMesh({0.3, 0.3, 1})), 0) << "post through a ring";
    EXPECT_EQ(overlapVolume(boxMesh({0.3, 0.3, 1}), ring), 0) << "post through a ring";
}

TEST(OverlapVolume, IsZeroWithinACavityWhicheverWayTheFacesAreCut) {
    // The diagonals of all these faces run through the centres of columns.
    for (bool turnCavity : {false, true})
        for (bool turnInner : {false, true}) {
            const TriangleMesh cavity = inverted(boxMesh({0.5, 0.5, 0.5})),
                               inner = boxMesh({0.25, 0.25, 0.25});
            const TriangleMesh outer =
                joined(boxMesh({1, 1, 1}), turnCavity ? quarterTurned(cavity) : cavity);
            EXPECT_EQ(overlapVolume(outer, turnInner ? quarterTurned(inner) : inner), 0);
            EXPECT_EQ(overlapVolume(turnInner ? quarterTurned(inner) : inner, outer), 0);
        }
}

TEST(OverlapVolume, IsZeroForFacesThatTouch) {
    const TriangleMesh box = boxMesh({1, 1, 1});
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0})
            EXPECT_EQ(overlapVolume(box, boxMesh({1, 1, 1}, side * Vec3::Unit(axis))), 0);
}

TEST(OverlapVolume, OfTurnedFacesThatTouchIsBelowWhatIsReported) {
    // Rounding to single precision lets touching faces of about 1 m share a layer of 1e-7 m.
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        const Pose pose{random.inCube(1), random.orientation()};
        TriangleMesh a = moved(boxMesh({1, 1, 1}), pose), b = moved(boxMesh({1, 1, 1}, {0.3, 1, 0.2}), pose);
        for (TriangleMesh* mesh : {&a, &b})
            for (Vec3& vertex : mesh->vertices)
                vertex = throughFloat(vertex);
        EXPECT_LT(overlapVolume(a, b), overlapTolerance);
    }
}

TEST(OverlapVolume, OfAlignedBoxesIsExact) {
    Random random(2);
    for (int i = 0; i < 50; ++i) {
        const Vec3 sizeA = Vec3::Ones() + random.inCube(0.5), sizeB = Vec3::Ones() + random.inCube(0.5);
        const Vec3 centreA = random.inCube(0.5), centreB = random.inCube(0.5);
        const Vec3 low = (centreA - sizeA / 2).cwiseMax(centreB - sizeB / 2);
        const Vec3 high = (centreA + sizeA / 2).cwiseMin(centreB + sizeB / 2);
        const double expected = (high - low).cwiseMax(0).prod();
        EXPECT_NEAR(overlapVolume(boxMesh(sizeA, centreA), boxMesh(sizeB, centreB)), expected, rounding);
    }
}

TEST(OverlapVolume, OfBoxesCutThroughTheCentresOfColumnsIsExact) {
    const TriangleMesh box = boxMesh({1, 1, 1}), high = boxMesh({1, 1, 1}, {0, 0, 0.5});
    for (const TriangleMesh& a : {box, quarterTurned(box), quartered(quartered(box))})
        for (const TriangleMesh& b : {high, quarterTurned(high), quartered(quarterTurned(high))})
            EXPECT_NEAR(overlapVolume(a, b), 0.5, rounding);
}

TEST(OverlapVolume, OfASolidWithinAnotherIsItsOwn) {
    const TriangleMesh inner = boxMesh({0.5, 0.3, 0.2}, {0.1, 0.2, -0.1});
    EXPECT_NEAR(overlapVolume(boxMesh({1, 1, 1}), inner), 0.03, rounding);
    EXPECT_NEAR(overlapVolume(inner, inner), 0.03, rounding);
    const TriangleMesh small = ball(0.2, {0.1, 0, 0});
    EXPECT_NEAR(overlapVolume(ball(0.5, Vec3::Zero()), small), volumeMoments(small).volume,
                promised * std::pow(0.4, 3));
}

TEST(OverlapVolume, OfTwoBallsIsALens) {
    for (double distance : {0.2, 0.5, 0.8}) {
        const double lens = pi / 12 * (4 * 0.5 + distance) * std::pow(2 * 0.5 - distance, 2);
        const Vec3 apart = distance * Vec3(2, -1, 2) / 3;
        const Vec3 common = Vec3::Ones() - apart.cwiseAbs();
        // An icosphere of 5,120 triangles lacks 0.2 % of the ball: up to 0.1 % of its radius at its surface
        // of pi m^2.
        EXPECT_NEAR(overlapVolume(ball(0.5, Vec3::Zero()), ball(0.5, apart)), lens,
                    promised * common.prod() + 0.001 * pi * 0.5);
    }
}

TEST(OverlapVolume, OfCrossedBarsIsThatOfTheirCrossing) {
    // Two square bars turned by 45 degrees about z have an octagon in common, two at 90 degrees a cube.
    const TriangleMesh bar = boxMesh({1, 1, 3});
    const Pose eighth{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(pi / 4, Vec3::UnitZ()))};
    EXPECT_NEAR(overlapVolume(bar, moved(bar, eighth)), 3 * 2 * (std::sqrt(2.0) - 1), promised * 3);
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
        const Pose quarter{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(pi / 2, axis))};
        EXPECT_NEAR(overlapVolume(bar, moved(bar, quarter)), 1, promised * 1);
    }
}

TEST(OverlapVolume, DoesNotDependOnTheOrder) {
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        const TriangleMesh a = moved(boxMesh({1, 0.5, 0.7}), {random.inCube(0.3), random.orientation()});
        const TriangleMesh b = moved(boxMesh({0.6, 0.8, 0.7}), {random.inCube(0.3), random.orientation()});
        EXPECT_NEAR(overlapVolume(a, b), overlapVolume(b, a), rounding);
    }
}

TEST(OverlapVolume, IsNearTheTruthForBoxesAnyWayRound) {
    // The truth by a finer midpoint rule: points of one box that are in the other.
    Random random(4);
    for (int i = 0; i < 20; ++i) {
        const Pose pose{random.inCube(0.5), random.orientation()};
        const Vec3 sizeA(1, 0.8, 0.6), sizeB(0.9, 0.7, 0.5);
        const int n = 60;
        double inside = 0;
        for (int x = 0; x < n; ++x)
            for (int y = 0; y < n; ++y)
                for (int z = 0; z < n; ++z) {
                    const Vec3 inA =
                        sizeA.cwiseProduct(Vec3(x + 0.5, y + 0.5, z + 0.5) / n - Vec3::Constant(0.5));
                    const Vec3 inB = pose.orientation.conjugate() * (inA - pose.position);
                    inside += ((inB.cwiseAbs() - sizeB / 2).array() < 0).all();
                }
        const double truth = inside * sizeA.prod() / (n * n * n);
        // Cells that straddle the smaller box's surface of 2.86 m^2 are counted by chance: half a cell times
        // the root of their number at most.
        const double cell = sizeA.prod() / (n * n * n), straddling = 2.86 / std::pow(cell, 2.0 / 3);
        EXPECT_NEAR(overlapVolume(boxMesh(sizeA), moved(boxMesh(sizeB), pose)), truth,
                    promised * sizeA.prod() + cell * std::sqrt(straddling));
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
