#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btMultimaterialTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <limits>
#include <type_traits>

#include "bullet/expect_hull.h"
#include "bullet_buoyancy/core/constants.h"
#include "support/edit_mesh.h"

namespace bullet_buoyancy::test {
namespace {

/// A user's own arrays, with room for something else after each vertex and each triangle.
template <typename Coordinate, typename Index>
class Arrays {
public:
    explicit Arrays(const TriangleMesh& mesh, std::size_t room = 0)
        : m_vertexLength(3 + room), m_triangleLength(3 + room) {
        for (const Vec3& vertex : mesh.vertices) {
            for (double x : vertex)
                m_coordinates.push_back(Coordinate(x));
            m_coordinates.insert(m_coordinates.end(), room, Coordinate(1e9));
        }
        for (const Triangle& triangle : mesh.triangles) {
            for (std::uint32_t index : triangle)
                m_indices.push_back(Index(index));
            m_indices.insert(m_indices.end(), room, std::numeric_limits<Index>::max());
        }
    }

    void addTo(btTriangleIndexVertexArray& source) const {
        btIndexedMesh view;
        view.m_numVertices = int(m_coordinates.size() / m_vertexLength);
        view.m_vertexBase = reinterpret_cast<const unsigned char*>(m_coordinates.data());
        view.m_vertexStride = int(m_vertexLength * sizeof(Coordinate));
        view.m_vertexType = std::is_same_v<Coordinate, double> ? PHY_DOUBLE : PHY_FLOAT;
        view.m_numTriangles = int(m_indices.size() / m_triangleLength);
        view.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(m_indices.data());
        view.m_triangleIndexStride = int(m_triangleLength * sizeof(Index));
        source.addIndexedMesh(view, sizeof(Index) == 4   ? PHY_INTEGER
                                    : sizeof(Index) == 2 ? PHY_SHORT
                                                         : PHY_UCHAR);
    }

private:
    std::size_t m_vertexLength, m_triangleLength;
    std::vector<Coordinate> m_coordinates;
    std::vector<Index> m_indices;
};

using BulletArrays = Arrays<btScalar, std::uint32_t>;

/// Neither convex nor about the origin nor the same along any two axes.
TriangleMesh ring() {
    return moved(ringMesh(0.3, 0.5, 0.1, 24), {{0.2, -0.1, 0.4}, Eigen::Quaterniond(0.8, 0.4, -0.2, 0.4)});
}

TriangleMesh scaled(TriangleMesh mesh, const Vec3& factors) {
    for (Vec3& vertex : mesh.vertices)
        vertex = vertex.cwiseProduct(factors);
    return factors.prod() < 0 ? inverted(mesh) : mesh;
}

/// With vertices that no triangle uses before all others.
TriangleMesh afterUnusedVertices(TriangleMesh mesh, std::uint32_t count) {
    mesh.vertices.insert(mesh.vertices.begin(), count, Vec3(5, 5, 5));
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& index : triangle)
            index += count;
    return mesh;
}

template <typename Coordinate, typename Index>
void expectRead(const TriangleMesh& mesh, std::size_t room) {
    const Arrays<Coordinate, Index> arrays(mesh, room);
    btTriangleIndexVertexArray source;
    arrays.addTo(source);
    // Single precision arrays round even if Bullet is in double precision.
    const double tolerance = std::is_same_v<Coordinate, float> ? 2e-6 : shapeRounding;
    expectHull(btBvhTriangleMeshShape(&source, true), solidOf(mesh), tolerance);
}

TEST(HullFromMesh, ReadsEveryLayoutOfArrays) {
    for (std::size_t room : {0u, 1u, 5u}) {
        expectRead<float, std::uint32_t>(ring(), room);
        expectRead<float, std::uint16_t>(ring(), room);
        expectRead<float, std::uint8_t>(ring(), room);
        expectRead<double, std::uint32_t>(ring(), room);
        expectRead<double, std::uint16_t>(ring(), room);
        expectRead<double, std::uint8_t>(ring(), room);
    }
}

TEST(HullFromMesh, ReadsLargeShortIndicesAsUnsigned) {
    const TriangleMesh box = boxMesh({1, 2, 3});
    expectRead<float, std::uint16_t>(afterUnusedVertices(box, 65535 - 7), 0);
    expectRead<float, std::uint8_t>(afterUnusedVertices(box, 255 - 7), 0);
}

TEST(HullFromMesh, ReadsBulletsTriangleMeshInAllItsKinds) {
    const TriangleMesh mesh = ring();
    for (bool use32BitIndices : {false, true})
        for (bool use4Components : {false, true})
            for (bool removeDuplicates : {false, true}) {
                btTriangleMesh source(use32BitIndices, use4Components);
                for (const Triangle& t : mesh.triangles)
                    source.addTriangle(toBullet(mesh.vertices[t[0]]), toBullet(mesh.vertices[t[1]]),
                                       toBullet(mesh.vertices[t[2]]), removeDuplicates);
                const HullResult result = expectHull(btBvhTriangleMeshShape(&source, true), solidOf(mesh));
                EXPECT_EQ(result.hull->mesh.vertices.size(), mesh.vertices.size());
            }
}

TEST(HullFromMesh, TakesAllSubPartsAsOneSurface) {
    // Half of a closed surface each: only together are they closed.
    const TriangleMesh mesh = ring();
    const auto half = std::ptrdiff_t(mesh.triangles.size() / 2);
    const Arrays<float, std::uint8_t> first(without(mesh, half, half));
    const Arrays<double, std::uint16_t> second(without(mesh, 0, half), 2);
    btTriangleIndexVertexArray source;
    first.addTo(source);
    second.addTo(source);
    const HullResult result = expectHull(btBvhTriangleMeshShape(&source, true), solidOf(mesh), 2e-6);
    EXPECT_EQ(result.hull->mesh.vertices.size(), mesh.vertices.size());
}

TEST(HullFromMesh, FollowsLocalScalingOfEveryMeshShape) {
    for (const Vec3& factors : {Vec3(1, 1, 1), Vec3(2, 0.5, 1.5), Vec3(-1, 2, 0.5), Vec3(-1, -2, -3)}) {
        const BulletArrays arrays(ring());
        const auto expectScaled = [&](auto&& makeShape) {
            btTriangleIndexVertexArray source;
            arrays.addTo(source);
            const auto shape = makeShape(source);
            shape->setLocalScaling(toBullet(factors));
            expectHull(*shape, solidOf(scaled(ring(), factors)));
        };
        expectScaled([](auto& source) { return std::make_unique<btBvhTriangleMeshShape>(&source, true); });
        expectScaled([](auto& source) { return std::make_unique<btConvexTriangleMeshShape>(&source); });
        expectScaled([](auto& source) { return std::make_unique<btGImpactMeshShape>(&source); });
        expectScaled([](auto& source) { return std::make_unique<btGImpactMeshShapePart>(&source, 0); });
        expectScaled(
            [](auto& source) { return std::make_unique<btMultimaterialTriangleMeshShape>(&source, true); });
    }
}

TEST(HullFromMesh, TurnsAMirroredMeshOutward) {
    const BulletArrays arrays(boxMesh({1, 2, 3}));
    btTriangleIndexVertexArray source;
    arrays.addTo(source);
    btBvhTriangleMeshShape shape(&source, true);
    shape.setLocalScaling({-1, 1, 1});
    const HullResult result = expectHull(shape, boxSolid({0.5, 1, 1.5}));
    EXPECT_EQ(result.status.flippedTriangles, 12u);
}

TEST(HullFromMesh, MultipliesTheScalingOfAScaledMeshWithThatOfItsChild) {
    const BulletArrays arrays(ring());
    btTriangleIndexVertexArray source;
    arrays.addTo(source);
    btBvhTriangleMeshShape child(&source, true);
    child.setLocalScaling({2, btScalar(0.5), 1});
    const Vec3 inner(2, 0.5, 1), outer(0.75, -3, 1.5);
    expectHull(btScaledBvhTriangleMeshShape(&child, toBullet(outer)),
               solidOf(scaled(ring(), inner.cwiseProduct(outer))));
    expectHull(btScaledBvhTriangleMeshShape(&child, {1, 1, 1}), solidOf(scaled(ring(), inner)));
}

TEST(HullFromMesh, TakesFromAGImpactMeshAllPartsAndFromAPartOnlyItsOwn) {
    const TriangleMesh large = ring(), small = boxMesh({0.2, 0.3, 0.4}, {3, 0, 0});
    const BulletArrays first(large), second(small);
    btTriangleIndexVertexArray source;
    first.addTo(source);
    second.addTo(source);
    const btGImpactMeshShape both(&source);
    expectHull(both, solidOf(joined(large, small)));
    expectHull(*both.getMeshPart(0), solidOf(large));
    expectHull(*both.getMeshPart(1), solidOf(small));
}

TEST(HullFromMesh, PlacesTheChildrenOfAGImpactCompound) {
    btSphereShape ball(btScalar(0.5)), bead(btScalar(0.25));
    const btQuaternion turn({0, 1, 0}, btScalar(0.7));
    btGImpactCompoundShape placed, unplaced;
    placed.addChildShape(btTransform(turn, {1, 2, 3}), &ball);
    placed.addChildShape(btTransform(turn, {1, 2, -3}), &bead);
    // Radii of 1/2 and 1/4: volumes as 8 to 1, areas as 4 to 1.
    const double bead3 = 4 * pi / 3 / 64, bead2 = 4 * pi / 16;
    expectHull(placed, {9 * bead3, {1, 2, (8 * 3.0 - 3) / 9}, 5 * bead2});
    unplaced.addChildShape(&ball);
    expectHull(unplaced, {8 * bead3, Vec3::Zero(), 4 * bead2});
}

TEST(HullFromMesh, RefusesIndicesOutOfRange) {
    for (std::uint32_t bad : {8u, 1000u, std::numeric_limits<std::uint32_t>::max()})
        for (std::size_t corner : {0u, 1u, 2u}) {
            TriangleMesh mesh = boxMesh({1, 1, 1});
            mesh.triangles[7][corner] = bad;
            const BulletArrays arrays(mesh);
            btTriangleIndexVertexArray source;
            arrays.addTo(source);
            // Bullet itself would read beyond the arrays for a bounding box and a tree.
            source.setPremadeAabb({-1, -1, -1}, {1, 1, 1});
            expectRefused(btBvhTriangleMeshShape(&source, true, false), HullError::badIndices);
            expectRefused(btGImpactMeshShape(&source), HullError::badIndices);
            expectRefused(btConvexTriangleMeshShape(&source, false), HullError::badIndices);
        }
}

TEST(HullFromMesh, RefusesAnIndexThatOnlyAnotherSubPartHas) {
    TriangleMesh mesh = boxMesh({1, 1, 1});
    mesh.triangles[7][1] = 8;
    const BulletArrays bad(mesh), good(boxMesh({1, 1, 1}, {2, 0, 0}));
    btTriangleIndexVertexArray source;
    bad.addTo(source);
    good.addTo(source);
    expectRefused(btGImpactMeshShape(&source), HullError::badIndices);
}

TEST(HullFromMesh, RefusesWhatHasNoTrianglesNoVolumeOrNoPlace) {
    btTriangleIndexVertexArray empty;
    expectRefused(btGImpactMeshShape(&empty), HullError::noTriangles);
    expectRefused(btGImpactCompoundShape(), HullError::noTriangles);

    const BulletArrays sheet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}});
    btTriangleIndexVertexArray flat;
    sheet.addTo(flat);
    expectRefused(btBvhTriangleMeshShape(&flat, true), HullError::noVolume);

    TriangleMesh mesh = boxMesh({1, 1, 1});
    mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    const BulletArrays lost(mesh);
    btTriangleIndexVertexArray notFinite;
    lost.addTo(notFinite);
    expectRefused(btGImpactMeshShape(&notFinite), HullError::notFinite);
}

TEST(HullFromMesh, AcceptsAnOpenMeshAndSaysSo) {
    const BulletArrays arrays(without(boxMesh({1, 1, 1}), 10, 2));
    btTriangleIndexVertexArray source;
    arrays.addTo(source);
    const HullResult result = hullFromShape(btBvhTriangleMeshShape(&source, true));
    EXPECT_TRUE(result.status.accepted());
    EXPECT_EQ(result.status.openEdges, 4u);
    EXPECT_FALSE(result.hull->meshIsClosed);
}

}  // namespace
}  // namespace bullet_buoyancy::test
