#include "bullet_buoyancy/hull/convex_hull.h"

#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/exact_determinant.h"
#include "bullet_buoyancy/hull/mesh_edges.h"
#include "bullet_buoyancy/hull/mesh_repair.h"
#include "bullet_buoyancy/hull/volume_moments.h"
#include "support/edit_mesh.h"
#include "support/near.h"

namespace bullet_buoyancy::test {
namespace {

/// Corners first, then points inside, on faces and on edges: a grid of step 1 / n.
std::vector<Vec3> boxPoints(const Vec3& size, int n) {
    std::vector<Vec3> corners, others;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            for (int k = 0; k <= n; ++k) {
                const bool corner = i % n == 0 && j % n == 0 && k % n == 0;
                const Vec3 place = Vec3(i, j, k) / n - Vec3::Constant(0.5);
                (corner ? corners : others).push_back(size.cwiseProduct(place));
            }
    corners.insert(corners.end(), others.begin(), others.end());
    return corners;
}

std::vector<Vec3> pointsOnSphere(int count, double radius, Random& random) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(radius * random.direction());
    return points;
}

/// Close to uniform: a Fibonacci lattice (Gonzalez 2010).
std::vector<Vec3> fibonacciSphere(int count) {
    std::vector<Vec3> points;
    const double goldenAngle = pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
        points.push_back({r * std::cos(goldenAngle * i), r * std::sin(goldenAngle * i), z});
    }
    return points;
}

std::vector<Vec3> movedPoints(std::vector<Vec3> points, const Pose& pose) {
    for (Vec3& point : points)
        point = pose.position + pose.orientation * point;
    return points;
}

/// How far points stick out of the hull, relative to the cloud's size, by a face's plane that is known well
/// enough: planes of slivers are uncertain by the rounding of their corners over their width.
double worstPointOutside(const TriangleMesh& hull, const std::vector<Vec3>& points) {
    const double size = meshSize({points, {}});
    double worst = 0;
    for (const Triangle& triangle : hull.triangles) {
        const Vec3 &a = hull.vertices[triangle[0]], &b = hull.vertices[triangle[1]],
                   &c = hull.vertices[triangle[2]];
        const Vec3 areaVector = (b - a).cross(c - a);
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        const double uncertainty = 10 * epsilon * size / (areaVector.norm() / longest);
        for (const Vec3& point : points)
            worst = std::max(worst, areaVector.normalized().dot(point - a) / size - uncertainty);
    }
    return worst;
}

std::size_t edgeCount(const TriangleMesh& mesh) {
    std::size_t edges = 0;
    forEachEdge(sortedHalfEdges(mesh), [&](auto, auto) { ++edges; });
    return edges;
}

void expectSphereOfTriangles(const TriangleMesh& hull) {
    EXPECT_EQ(countOpenEdges(hull), 0u);
    EXPECT_EQ(hull.vertices.size() + hull.triangles.size(), edgeCount(hull) + 2) << "Euler";
    EXPECT_GT(volumeMoments(hull).volume, 0);
}

void expectConvexHull(const TriangleMesh& hull, const std::vector<Vec3>& points) {
    ASSERT_FALSE(hull.triangles.empty());
    expectSphereOfTriangles(hull);
    // A point is left out by its distance from the planes that are there at the time, which may be less than
    // from a sharp edge between them.
    EXPECT_LE(worstPointOutside(hull, points), 2 * convexHullTolerance);
}

/// Whole numbers up to 2^50 with determinant 1: shears of the identity.
Mat3 randomUnimodular(Random& random) {
    Mat3 matrix = Mat3::Identity();
    while (true) {
        const std::size_t to = random.index(3), from = (to + 1 + random.index(2)) % 3;
        Mat3 sheared = matrix;
        sheared.col(Eigen::Index(to)) += (random.coin() ? 1.0 : -1.0) * matrix.col(Eigen::Index(from));
        if (sheared.cwiseAbs().maxCoeff() > 0x1p50) return matrix;
        matrix = sheared;
    }
}

TEST(ExactDeterminant, IsOneWhereRoundingWouldLoseIt) {
    Random random(20);
    for (int i = 0; i < 1000; ++i) {
        const Mat3 m = randomUnimodular(random);
        EXPECT_EQ(exactDeterminant(m.col(0), m.col(1), m.col(2)), 1);
        EXPECT_EQ(exactDeterminant(m.col(1), m.col(0), m.col(2)), -1);
        EXPECT_EQ(exactDeterminant(m.col(0), m.col(1), m.col(0) + m.col(1)), 0);
    }
}

TEST(ExactDeterminant, AgreesWithThePlainOneWhereNothingCancels) {
    Random random(21);
    for (int i = 0; i < 1000; ++i) {
        Mat3 m;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            m.col(axis) = random.inCube(0x1p50).array().round();
        EXPECT_NEAR(exactDeterminant(m.col(0), m.col(1), m.col(2)) / m.determinant(), 1,
                    100 * epsilon * 0x1p150 / std::abs(m.determinant()));
    }
}

TEST(ConvexHull, OfABoxHasTwelveTrianglesWhateverLiesInsideAndOnIt) {
    Random random(1);
    for (int n : {1, 2, 3, 4, 7}) {
        std::vector<Vec3> points = boxPoints({2, 3, 5}, n);
        for (int i = 0; i < 20; ++i) {
            const TriangleMesh hull = convexHull(points);
            expectConvexHull(hull, points);
            EXPECT_EQ(hull.vertices.size(), 8u);
            EXPECT_EQ(hull.triangles.size(), 12u);
            EXPECT_NEAR(volumeMoments(hull).volume, 30, 30 * 100 * epsilon);
            shuffle(points, random);
        }
    }
}

TEST(ConvexHull, OfATurnedBoxHasTheSameVolume) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Pose pose{random.inCube(10), random.orientation()};
        std::vector<Vec3> points = movedPoints(boxPoints({2, 3, 5}, 3), pose);
        shuffle(points, random);
        const TriangleMesh hull = convexHull(points);
        expectConvexHull(hull, points);
        EXPECT_EQ(hull.vertices.size(), 8u);
        // Points may be left out by the tolerance times the size of 6 m, over 62 m^2.
        EXPECT_NEAR(volumeMoments(hull).volume, 30, 62 * 6.2 * convexHullTolerance);
        EXPECT_TRUE(isNear(volumeMoments(hull).centroid(), pose.position, 62 * 6.2 * convexHullTolerance));
    }
}

TEST(ConvexHull, OfATetrahedronIsTheTetrahedron) {
    const TriangleMesh hull = convexHull({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
    EXPECT_EQ(hull.triangles.size(), 4u);
    EXPECT_EQ(countOpenEdges(hull), 0u);
    EXPECT_DOUBLE_EQ(volumeMoments(hull).volume, 1);
}

TEST(ConvexHull, HoldsRandomPointsOnASphereAndHasThemAllAsVertices) {
    Random random(3);
    for (int count : {4, 5, 6, 10, 30, 100, 300, 1000, 2000}) {
        const std::vector<Vec3> points = pointsOnSphere(count, 3, random);
        const TriangleMesh hull = convexHull(points);
        expectConvexHull(hull, points);
        EXPECT_EQ(hull.vertices.size(), std::size_t(count));
        EXPECT_EQ(hull.triangles.size(), std::size_t(2 * count - 4));
    }
}

TEST(ConvexHull, HoldsRandomPointsInACube) {
    Random random(4);
    for (int count : {4, 5, 8, 20, 100, 1000, 4000}) {
        std::vector<Vec3> points;
        for (int i = 0; i < count; ++i)
            points.push_back(Vec3(5, 6, 7) + random.inCube(1));
        expectConvexHull(convexHull(points), points);
    }
}

TEST(ConvexHull, HoldsPointsRoundedToSinglePrecision) {
    // Faces that were flat come apart into slivers 1e-8 of the size deep; nothing may be lost by that.
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const Pose pose{random.inCube(10), random.orientation()};
        std::vector<Vec3> points = movedPoints(boxPoints({2, 3, 5}, 1 + i % 6), pose);
        for (Vec3& point : points)
            point = throughFloat(point);
        const TriangleMesh hull = convexHull(points);
        expectConvexHull(hull, points);
        // Coordinates are below 16: rounded to 2^-21 at worst, over 62 m^2.
        EXPECT_NEAR(volumeMoments(hull).volume, 30, 62 * 0x1p-20);
    }
}

TEST(ConvexHull, HoldsPointsThatLieNearFacesByAnyDistance) {
    // Noise from far below the tolerance to far above it: at the tolerance itself each point is a doubtful
    // case.
    Random random(6);
    for (double noise = 1e-16; noise < 1e-3; noise *= 3)
        for (int i = 0; i < 10; ++i) {
            std::vector<Vec3> points = boxPoints({1, 1, 1}, 5);
            for (Vec3& point : points)
                point += noise * random.inCube(1);
            const Pose pose{random.inCube(1), random.orientation()};
            points = movedPoints(points, pose);
            shuffle(points, random);
            const TriangleMesh hull = convexHull(points);
            expectConvexHull(hull, points);
            EXPECT_NEAR(volumeMoments(hull).volume, 1, 6 * (2 * noise + 2 * convexHullTolerance)) << noise;
        }
}

TEST(ConvexHull, HoldsPrismsAndConesWithManyPointsOnACircle) {
    Random random(7);
    for (std::uint32_t segments : {3u, 8u, 64u, 500u})
        for (double topRadius : {0.0, 0.3, 1.0}) {
            std::vector<Vec3> points;
            for (std::uint32_t i = 0; i < segments; ++i) {
                const double angle = 2 * pi * i / segments;
                const Vec3 radial(std::cos(angle), std::sin(angle), 0);
                points.push_back(radial);
                points.push_back(topRadius * radial + Vec3::UnitZ());
            }
            const double polygon = segments / 2.0 * std::sin(2 * pi / segments);
            const double frustum = polygon * (1 + topRadius + topRadius * topRadius) / 3;
            points = movedPoints(points, {random.inCube(1), random.orientation()});
            shuffle(points, random);
            const TriangleMesh hull = convexHull(points);
            expectConvexHull(hull, points);
            // Size 2.2 m, area below 13 m^2.
            EXPECT_NEAR(volumeMoments(hull).volume, frustum, 13 * 2.2 * convexHullTolerance);
        }
}

TEST(ConvexHull, TendsToTheSphereAsItsPointsGrowInNumber) {
    // Inscribed triangles stand off by the square of their size: the missing share goes as 1 over the number
    // of points.
    const double sphere = 4 * pi / 3;
    double before = 0;
    for (int count : {250, 1000, 4000}) {
        const std::vector<Vec3> points = fibonacciSphere(count);
        const double missing = 1 - volumeMoments(convexHull(points)).volume / sphere;
        EXPECT_GT(missing, 0);
        if (before >
            0) {  // the lattice's triangles change their shape from one number to another: some per cent
            EXPECT_NEAR(before / missing, 4, 0.4);
        }
        before = missing;
    }
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfThePoints) {
    Random random(8);
    std::vector<Vec3> points = pointsOnSphere(500, 1, random);
    const double volume = volumeMoments(convexHull(points)).volume;
    for (int i = 0; i < 50; ++i) {
        shuffle(points, random);
        EXPECT_NEAR(volumeMoments(convexHull(points)).volume, volume, 12.6 * 2 * convexHullTolerance);
    }
}

TEST(ConvexHull, DoesNotDependOnScale) {
    Random random(9);
    const std::vector<Vec3> points = pointsOnSphere(100, 1, random);
    const double volume = volumeMoments(convexHull(points)).volume;
    for (double scale : {0x1p-60, 0x1p-10, 0x1p10, 0x1p60}) {  // exact in binary: the same roundings
        std::vector<Vec3> scaled = points;
        for (Vec3& point : scaled)
            point *= scale;
        EXPECT_NEAR(volumeMoments(convexHull(scaled)).volume / std::pow(scale, 3), volume, 1000 * epsilon);
    }
}

TEST(ConvexHull, TakesRepeatedPoints) {
    Random random(10);
    std::vector<Vec3> points = pointsOnSphere(60, 1, random);
    const double volume = volumeMoments(convexHull(points)).volume;
    points.insert(points.end(), points.begin(), points.end());
    points.insert(points.begin(), 100, points[7]);
    const TriangleMesh hull = convexHull(points);
    expectConvexHull(hull, points);
    EXPECT_EQ(hull.vertices.size(), 60u);
    EXPECT_NEAR(volumeMoments(hull).volume, volume, 1000 * epsilon);
}

TEST(ConvexHull, OfPointsInOnePlaneHasNoTriangles) {
    Random random(11);
    EXPECT_TRUE(convexHull({}).triangles.empty());
    for (int dimensions : {0, 1, 2})
        for (int count : {1, 2, 3, 4, 5, 100})
            for (int i = 0; i < 20; ++i) {
                std::vector<Vec3> points;
                for (int j = 0; j < count; ++j) {
                    Vec3 point = random.inCube(1);
                    for (int axis = dimensions; axis < 3; ++axis)
                        point[axis] = 0;
                    points.push_back(point);
                }
                EXPECT_TRUE(convexHull(points).triangles.empty()) << dimensions << " " << count;
                points = movedPoints(points, {random.inCube(1), random.orientation()});
                EXPECT_TRUE(convexHull(points).triangles.empty()) << dimensions << " " << count;
            }
}

TEST(ConvexHull, HoldsPlatesAsThinAsTheNoiseOfTheirPoints) {
    // What a point sees is in doubt everywhere here: decided by rounding, the horizon soon tears.
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const double noise = std::pow(10, -random.uniform(6, 17));
        const double thickness = std::pow(10, -random.uniform(0, 10));
        std::vector<Vec3> points = boxPoints({1, 1, thickness}, 2 + i % 5);
        for (Vec3& point : points)
            point += noise * random.inCube(1);
        if (i % 2) points = movedPoints(points, {Vec3::Zero(), random.orientation()});
        shuffle(points, random);
        const TriangleMesh hull = convexHull(points);
        if (hull.triangles.empty()) {
            // No point is farther than that from a plane through the middle; the size is 1.5 m.
            EXPECT_LT(thickness, 2 * 1.5 * convexHullTolerance);
            continue;
        }
        expectSphereOfTriangles(hull);
        // Two faces of 1 m^2, each moved by noise and by what may be left out.
        EXPECT_NEAR(volumeMoments(hull).volume, thickness, 2 * (2 * noise + 2 * 1.5 * convexHullTolerance));
    }
}

TEST(ConvexHull, HoldsThinPlates) {
    // A plate far thicker than the tolerance, far thinner than its points are apart.
    Random random(12);
    for (double thickness : {1e-3, 1e-5, 1e-7, 1e-8})
        for (int i = 0; i < 20; ++i) {
            std::vector<Vec3> points = boxPoints({1, 1, thickness}, 4);
            points = movedPoints(points, {Vec3::Zero(), random.orientation()});
            shuffle(points, random);
            const TriangleMesh hull = convexHull(points);
            expectConvexHull(hull, points);
            EXPECT_NEAR(volumeMoments(hull).volume, thickness, 2 * 2 * 1.5 * convexHullTolerance)
                << thickness;
        }
}

}  // namespace
}  // namespace bullet_buoyancy::test
