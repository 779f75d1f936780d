#include "bullet_buoyancy/bullet/read_striding_mesh.h"

#include <cstring>
#include <limits>

namespace bullet_buoyancy {

namespace {

/// A value of the user's array, which need not be aligned.
template <typename T>
T load(const unsigned char* bytes, int index) {
    T value;
    std::memcpy(&value, bytes + std::size_t(index) * sizeof(T), sizeof(T));
    return value;
}

std::uint32_t loadIndex(const unsigned char* bytes, PHY_ScalarType type, int corner) {
    switch (type) {
        case PHY_SHORT:
            return load<std::uint16_t>(bytes, corner);
        case PHY_UCHAR:
            return load<std::uint8_t>(bytes, corner);
        default:
            return load<std::uint32_t>(bytes, corner);
    }
}

double loadCoordinate(const unsigned char* bytes, PHY_ScalarType type, int axis) {
    return type == PHY_DOUBLE ? load<double>(bytes, axis) : double(load<float>(bytes, axis));
}

}  // namespace

void readStridingMesh(const btStridingMeshInterface& source, int part, const Vec3& scaling,
                      TriangleMesh& mesh) {
    const unsigned char *vertices = nullptr, *indices = nullptr;
    int vertexCount = 0, vertexStride = 0, triangleCount = 0, triangleStride = 0;
    PHY_ScalarType vertexType = PHY_FLOAT, indexType = PHY_INTEGER;
    source.getLockedReadOnlyVertexIndexBase(&vertices, vertexCount, vertexType, vertexStride, &indices,
                                            triangleStride, triangleCount, indexType, part);
    const auto offset = std::uint32_t(mesh.vertices.size());
    for (int i = 0; i < vertexCount; ++i) {
        const unsigned char* vertex = vertices + std::size_t(i) * std::size_t(vertexStride);
        mesh.vertices.push_back({scaling.x() * loadCoordinate(vertex, vertexType, 0),
                                 scaling.y() * loadCoordinate(vertex, vertexType, 1),
                                 scaling.z() * loadCoordinate(vertex, vertexType, 2)});
    }
    const auto corner = [&](const unsigned char* triangle, int i) {
        const std::uint32_t index = loadIndex(triangle, indexType, i);
        const bool inRange = index < std::uint32_t(vertexCount);
        return inRange ? offset + index : std::numeric_limits<std::uint32_t>::max();
    };
    for (int i = 0; i < triangleCount; ++i) {
        const unsigned char* triangle = indices + std::size_t(i) * std::size_t(triangleStride);
        mesh.triangles.push_back({corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)});
    }
    source.unLockReadOnlyVertexBase(part);
}

}  // namespace bullet_buoyancy
