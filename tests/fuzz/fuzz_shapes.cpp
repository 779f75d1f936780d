// Any of Bullet's collision shapes as a hull: refused with a reason, or sound, and the same when it is moved.

#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "bullet_buoyancy/core/constants.h"
#include "fuzz/check_hull.h"
#include "fuzz/choices.h"
#include "fuzz/read_mesh.h"

namespace bullet_buoyancy::fuzz {
namespace {

constexpr int deepest = 3;  // of shapes within shapes

btScalar scalar(Input& input) {
    return btScalar(input.number());
}

btVector3 vector(Input& input) {
    const btScalar x = scalar(input), y = scalar(input);
    return {x, y, scalar(input)};
}

btTransform transform(Input& input) {
    const Vec3 axis = input.inCube();
    return toTransform(
        {input.inCube(),
         Eigen::Quaterniond(1 + input.unit(), axis.x(), axis.y(), axis.z() + 1e-3).normalized()});
}

/// The arrays of a mesh, as a user would have them.
class Arrays {
public:
    Arrays(const TriangleMesh& mesh, Input& input) {
        m_indexType = indexTypes[input.index(3)];
        m_vertexType = input.coin() ? PHY_FLOAT : PHY_DOUBLE;
        m_vertexCount = int(mesh.vertices.size());
        m_triangleCount = int(mesh.triangles.size());
        const int vertexPadding = input.index(3) * 4, trianglePadding = input.index(3) * 4;
        for (const Vec3& vertex : mesh.vertices) {
            for (double coordinate : vertex)
                m_vertexType == PHY_FLOAT ? put(m_vertices, float(coordinate)) : put(m_vertices, coordinate);
            pad(m_vertices, vertexPadding);
        }
        for (const Triangle& triangle : mesh.triangles) {
            for (std::uint32_t corner : triangle)
                putIndex(corner);
            pad(m_indices, trianglePadding);
        }
        if (m_vertexCount > 0) m_vertexStride = int(m_vertices.size()) / m_vertexCount;
        if (m_triangleCount > 0) m_triangleStride = int(m_indices.size()) / m_triangleCount;
    }

    void addTo(btTriangleIndexVertexArray& array) const {
        btIndexedMesh part;
        part.m_numTriangles = m_triangleCount;
        part.m_triangleIndexBase = m_indices.data();
        part.m_triangleIndexStride = m_triangleStride;
        part.m_numVertices = m_vertexCount;
        part.m_vertexBase = m_vertices.data();
        part.m_vertexStride = m_vertexStride;
        part.m_vertexType = m_vertexType;
        array.addIndexedMesh(part, m_indexType);
    }

private:
    static constexpr PHY_ScalarType indexTypes[] = {PHY_INTEGER, PHY_SHORT, PHY_UCHAR};

    using Bytes = std::vector<unsigned char>;

    template <typename T>
    static void put(Bytes& bytes, T value) {
        const std::size_t at = bytes.size();
        bytes.resize(at + sizeof value);
        std::memcpy(bytes.data() + at, &value, sizeof value);
    }

    static void pad(Bytes& bytes, int padding) { bytes.insert(bytes.end(), std::size_t(padding), 0xff); }

    void putIndex(std::uint32_t index) {
        if (m_indexType == PHY_INTEGER) put(m_indices, index);
        if (m_indexType == PHY_SHORT) put(m_indices, std::uint16_t(index));
        if (m_indexType == PHY_UCHAR) put(m_indices, std::uint8_t(index));
    }

    PHY_ScalarType m_indexType, m_vertexType;
    Bytes m_vertices, m_indices;
    int m_vertexCount, m_triangleCount, m_vertexStride = 0, m_triangleStride = 0;
};

/// Makes shapes, and keeps what they are made of.
class Shapes {
public:
    explicit Shapes(Input& input) : m_input(input) {}

    ~Shapes() {
        while (!m_shapes.empty())  // those that have children first
            m_shapes.pop_back();
    }
    Shapes(const Shapes&) = delete;
    Shapes& operator=(const Shapes&) = delete;

    btCollisionShape& make(int depth = 0) { return make(m_input.index(shapeKinds), depth); }

    template <typename Shape, typename... Args>
    Shape& add(Args&&... args) {
        m_shapes.push_back(std::make_unique<Shape>(std::forward<Args>(args)...));
        return static_cast<Shape&>(*m_shapes.back());
    }

private:
    btCollisionShape& make(int kind, int depth) {
        if (kind <= triangleShape) return vary(convex(kind));
        if (kind >= convexMeshShape && kind <= gimpactMeshShape) return mesh(kind);
        if (kind == planeShape) return add<btStaticPlaneShape>(vector(m_input), scalar(m_input));
        if (kind == box2dShape) return add<btBox2dShape>(vector(m_input));
        if (kind == emptyShape || depth == deepest) return add<btEmptyShape>();
        if (kind == compoundShape) return compound(depth);
        if (kind == gimpactCompoundShape) return gimpactCompound(depth);
        auto& child = static_cast<btConvexShape&>(vary(convex(m_input.index(coneShape + 1))));
        if (kind == uniformScalingShape) return add<btUniformScalingShape>(&child, scalar(m_input));
        return minkowskiSum(child);
    }

    btConvexShape& convex(int kind) {
        switch (kind) {
            case sphereShape:
                return add<btSphereShape>(scalar(m_input));
            case capsuleShape:
                return capsule();
            case cylinderShape:
                return cylinder();
            case coneShape:
                return cone();
            case multiSphereShape:
                return multiSphere();
            case convexHullShape: {
                auto& hull = add<btConvexHullShape>();
                for (int i = m_input.index(40); i > 0; --i)
                    hull.addPoint(vector(m_input), false);
                return hull;
            }
            case pointCloudShape:
                return pointCloud();
            case tetrahedronShape: {
                const btVector3 a = vector(m_input), b = vector(m_input), c = vector(m_input);
                return add<btBU_Simplex1to4>(a, b, c, vector(m_input));
            }
            case triangleShape: {
                const btVector3 a = vector(m_input), b = vector(m_input);
                return add<btTriangleShape>(a, b, vector(m_input));
            }
            default:
                return add<btBoxShape>(vector(m_input));
        }
    }

    btConvexShape& capsule() {
        const btScalar radius = scalar(m_input), height = scalar(m_input);
        switch (m_input.index(3)) {
            case 0:
                return add<btCapsuleShapeX>(radius, height);
            case 1:
                return add<btCapsuleShape>(radius, height);
            default:
                return add<btCapsuleShapeZ>(radius, height);
        }
    }

    btConvexShape& cylinder() {
        const btVector3 half = vector(m_input);
        switch (m_input.index(3)) {
            case 0:
                return add<btCylinderShapeX>(half);
            case 1:
                return add<btCylinderShape>(half);
            default:
                return add<btCylinderShapeZ>(half);
        }
    }

    btConvexShape& cone() {
        const btScalar radius = scalar(m_input), height = scalar(m_input);
        switch (m_input.index(3)) {
            case 0:
                return add<btConeShapeX>(radius, height);
            case 1:
                return add<btConeShape>(radius, height);
            default:
                return add<btConeShapeZ>(radius, height);
        }
    }

    btConvexShape& multiSphere() {
        std::vector<btVector3> centres;
        std::vector<btScalar> radii;
        for (int i = 1 + m_input.index(3); i > 0; --i) {
            centres.push_back(vector(m_input));
            radii.push_back(scalar(m_input));
        }
        return add<btMultiSphereShape>(centres.data(), radii.data(), int(radii.size()));
    }

    btConvexShape& pointCloud() {
        m_points.push_back(std::make_unique<std::vector<btVector3>>());
        std::vector<btVector3>& points = *m_points.back();
        for (int i = 1 + m_input.index(40); i > 0; --i)
            points.push_back(vector(m_input));
        return add<btConvexPointCloudShape>(points.data(), int(points.size()), vector(m_input), false);
    }

    btConvexShape& vary(btConvexShape& shape) {
        const int change = m_input.byte();
        if (change & 1) shape.setMargin(scalar(m_input));
        if (change & 2) shape.setLocalScaling(vector(m_input));
        return shape;
    }

    /// Bullet itself reads what stray indices point at, in all meshes but one that is not asked for its box.
    btCollisionShape& mesh(int kind) {
        m_meshes.push_back(std::make_unique<btTriangleIndexVertexArray>());
        btTriangleIndexVertexArray& meshes = *m_meshes.back();
        for (int i = m_input.index(3); i > 0; --i) {
            TriangleMesh mesh = readMesh(m_input);
            if (kind != convexMeshShape && hasStrayIndex(mesh)) mesh.triangles.clear();
            if (mesh.vertices.size() > 255)
                mesh = test::boxMesh({1, 1, 1});  // more than small indices can tell
            m_arrays.push_back(std::make_unique<Arrays>(mesh, m_input));
            m_arrays.back()->addTo(meshes);
        }
        if (m_input.coin()) meshes.setScaling(vector(m_input));
        if (kind == convexMeshShape) return add<btConvexTriangleMeshShape>(&meshes, false);
        if (kind == gimpactMeshShape) return add<btGImpactMeshShape>(&meshes);
        auto& bvh = add<btBvhTriangleMeshShape>(&meshes, true, false);
        if (kind == bvhMeshShape) return bvh;
        return add<btScaledBvhTriangleMeshShape>(&bvh, vector(m_input));
    }

    btCollisionShape& compound(int depth) {
        std::vector<btCollisionShape*> children;
        for (int i = m_input.index(4); i > 0; --i)
            children.push_back(&make(depth + 1));
        auto& compound = add<btCompoundShape>(false);
        for (btCollisionShape* child : children)
            compound.addChildShape(transform(m_input), child);
        return compound;
    }

    btCollisionShape& gimpactCompound(int depth) {
        std::vector<btCollisionShape*> children;
        for (int i = m_input.index(4); i > 0; --i)
            children.push_back(&make(depth + 1));
        const bool hasTransforms = m_input.coin();
        auto& compound = add<btGImpactCompoundShape>(hasTransforms);
        for (btCollisionShape* child : children)
            hasTransforms ? compound.addChildShape(transform(m_input), child) : compound.addChildShape(child);
        return compound;
    }

    /// With no more than one smooth member: two have a million points.
    btCollisionShape& minkowskiSum(btConvexShape& child) {
        auto& sum = add<btMinkowskiSumShape>(&child, &convex(boxShape));
        sum.setTransformA(transform(m_input));
        sum.setTransformB(transform(m_input));
        return sum;
    }

    Input& m_input;
    std::vector<std::unique_ptr<std::vector<btVector3>>> m_points;
    std::vector<std::unique_ptr<Arrays>> m_arrays;
    std::vector<std::unique_ptr<btTriangleIndexVertexArray>> m_meshes;
    std::vector<std::unique_ptr<btCollisionShape>> m_shapes;
};

/// Whether it fills much of the sphere about it, with no more surface than that has.
bool isCompact(const Hull& hull) {
    const double r = hull.bounds.radius;
    return hull.moments.volume > 1e-3 * (4 * pi / 3) * r * r * r && hull.surfaceArea < 4 * pi * r * r;
}

/// Reading a sheet may come to another end where it lies otherwise; a solid not. Points are rounded to 1e-7
/// of their distance, and those of a convex hull may be left out.
void checkMoved(const Hull& hull, btCollisionShape& shape, Shapes& shapes, Input& input) {
    auto& around = shapes.add<btCompoundShape>(false);
    around.addChildShape(transform(input), &shape);
    const HullResult moved = hullFromShape(around);
    checkHull(moved);
    if (!hull.meshIsClosed || !isCompact(hull) || hull.bounds.centre.norm() > 10 * hull.bounds.radius) return;
    BUOYANCY_EXPECT(moved.hull, "%s", moved.status.describe().c_str());
    const double off = moved.hull->moments.volume / hull.moments.volume - 1;
    BUOYANCY_EXPECT(std::abs(off) < 1e-3, "%g m^3, moved %g m^3", hull.moments.volume,
                    moved.hull->moments.volume);
}

}  // namespace
}  // namespace bullet_buoyancy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace bullet_buoyancy::fuzz;
    Input input(bytes, size);
    Shapes shapes(input);
    btCollisionShape& shape = shapes.make();
    const auto result = bullet_buoyancy::hullFromShape(shape);
    checkHull(result);
    if (result.hull) checkMoved(*result.hull, shape, shapes, input);
    return 0;
}
