#include "bullet_buoyancy/hull/packed_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "bullet_buoyancy/hull/surface_moments.h"
#include "bullet_buoyancy/hull/volume_moments.h"
#include "support/bumpy_mesh.h"
#include "support/known_solids.h"

namespace bullet_buoyancy::test {
namespace {

const Vec3 origin(0.3, -0.2, 0.1);

template <typename Real>
Vec3 corner(const PackRow<Real> (&rows)[3], std::size_t lane) {
    return Vec3(rows[0].lane[lane], rows[1].lane[lane], rows[2].lane[lane]);
}

/// Corners of a triangle, beginning with the lowest in x, y, z.
std::array<Vec3, 3> turned(std::array<Vec3, 3> t) {
    const auto less = [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::rotate(t.begin(), std::min_element(t.begin(), t.end(), less), t.end());
    return t;
}

bool operator<(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
    return std::lexicographical_compare(a[0].data(), a[0].data() + 9, b[0].data(), b[0].data() + 9);
}

TEST(PackedMesh, HasEveryTriangleOnce) {
    const TriangleMesh mesh = bumpyMesh(3);
    const PackedMesh packed = packMesh(mesh, origin);
    std::vector<std::array<Vec3, 3>> given, found;
    for (const Triangle& t : mesh.triangles)
        given.push_back(turned(
            {mesh.vertices[t[0]] - origin, mesh.vertices[t[1]] - origin, mesh.vertices[t[2]] - origin}));
    for (const TrianglePack<double>& pack : packed.full.packs)
        for (std::size_t lane = 0; lane < packSize; ++lane)
            if (pack.area.lane[lane] > 0)
                found.push_back(turned({corner(pack.a, lane), corner(pack.b, lane), corner(pack.c, lane)}));
    ASSERT_EQ(given.size(), found.size());
    const auto less = [](const auto& a, const auto& b) { return a < b; };
    std::sort(given.begin(), given.end(), less);
    std::sort(found.begin(), found.end(), less);
    EXPECT_TRUE(given == found);
}

TEST(PackedMesh, AreaVectorsCloseInSinglePrecisionToo) {
    const PackedMesh packed = packMesh(bumpyMesh(3), origin);
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (const TrianglePack<float>& pack : packed.single.packs)
        for (std::size_t lane = 0; lane < packSize; ++lane) {
            sum += corner(pack.areaVector, lane);
            area += double(pack.area.lane[lane]);
        }
    // 1,280 numbers, each rounded once.
    EXPECT_LT(sum.norm(), area * std::numeric_limits<float>::epsilon());
}

/// Boxes of clusters about those of their children, down to corners; float boxes as well as double ones.
template <typename Real>
void expectBoxesAround(const PackedTriangles<Real>& mesh) {
    ASSERT_FALSE(mesh.levels.empty());
    const auto boxOf = [](const Cluster<Real>& cluster, std::size_t lane) {
        const Vec3 centre = corner(cluster.centre, lane), half = corner(cluster.halfExtents, lane);
        return Eigen::AlignedBox3d(centre - half, centre + half);
    };
    for (std::size_t i = 0; i < mesh.packs.size(); ++i)
        for (std::size_t lane = 0; lane < packSize; ++lane) {
            const TrianglePack<Real>& pack = mesh.packs[i];
            if (!(pack.area.lane[lane] > 0)) continue;
            std::size_t child = i;
            for (const auto& level : mesh.levels) {
                const Eigen::AlignedBox3d box = boxOf(level[child / packSize], child % packSize);
                EXPECT_TRUE(box.contains(corner(pack.a, lane)) && box.contains(corner(pack.b, lane)) &&
                            box.contains(corner(pack.c, lane)));
                child /= packSize;
            }
        }
}

TEST(PackedMesh, BoxesEncloseWhatIsBelow) {
    const PackedMesh packed = packMesh(bumpyMesh(4), Vec3(10, 20, 30));
    expectBoxesAround(packed.full);
    expectBoxesAround(packed.single);
}

/// The volume, and the integral of x over it, are surface integrals that the moments of the highest
/// clusters must give.
TEST(PackedMesh, MomentsOfTheHighestClustersAreThoseOfTheSolid) {
    const TriangleMesh mesh = bumpyMesh(4);
    const PackedMesh packed = packMesh(mesh, Vec3::Zero());
    const VolumeMoments expected = volumeMoments(mesh);
    double volume = 0;
    Vec3 normal = Vec3::Zero(), unsignedNormal = Vec3::Zero(), firstMoment = Vec3::Zero();
    for (const Cluster<double>& cluster : packed.full.levels.back())
        for (std::size_t lane = 0; lane < packSize; ++lane) {
            const MomentRows<double>& moments = cluster.moments;
            normal += corner(moments.normal, lane);
            unsignedNormal += corner(moments.unsignedNormal, lane);
            volume += moments.first[2][2].lane[lane];
            firstMoment += Vec3(moments.second[0][0].lane[lane] / 2, moments.second[3][1].lane[lane] / 2,
                                moments.second[5][2].lane[lane] / 2);
        }
    // Rounding of sums of 5,120 numbers.
    const double rounding = 1e-13;
    EXPECT_LT(normal.norm(), rounding);
    EXPECT_LT((unsignedNormal - 2 * surfaceMoments(mesh).shadows).norm(), rounding);
    EXPECT_NEAR(volume, expected.volume, rounding);
    EXPECT_LT((firstMoment - expected.firstMoment).norm(), rounding);
}

TEST(PackedMesh, MeshesOfAFewPacksHaveNoClusters) {
    EXPECT_TRUE(packMesh(boxMesh(Vec3(1, 2, 3)), Vec3::Zero()).full.levels.empty());
    EXPECT_EQ(packMesh(boxMesh(Vec3(1, 2, 3)), Vec3::Zero()).full.packs.size(), 1u);
}

}  // namespace
}  // namespace bullet_buoyancy::test
