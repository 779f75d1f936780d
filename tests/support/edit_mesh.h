#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/hull/triangle_mesh.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

inline Triangle turned(const Triangle& triangle) {
    return {triangle[0], triangle[2], triangle[1]};
}

/// Inside out.
inline TriangleMesh inverted(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles)
        triangle = turned(triangle);
    return mesh;
}

/// Both in one mesh, without a common vertex.
inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
    const auto offset = std::uint32_t(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

inline TriangleMesh moved(TriangleMesh mesh, const Pose& pose) {
    for (Vec3& vertex : mesh.vertices)
        vertex = pose.position + pose.orientation * vertex;
    return mesh;
}

/// Without `count` triangles from number `first` on.
inline TriangleMesh without(TriangleMesh mesh, std::ptrdiff_t first, std::ptrdiff_t count) {
    mesh.triangles.erase(mesh.triangles.begin() + first, mesh.triangles.begin() + first + count);
    return mesh;
}

/// Every triangle with three vertices of its own, as in an STL file.
inline TriangleMesh soup(const TriangleMesh& mesh) {
    TriangleMesh result;
    for (const Triangle& triangle : mesh.triangles) {
        const auto first = std::uint32_t(result.vertices.size());
        for (std::uint32_t corner : triangle)
            result.vertices.push_back(mesh.vertices[corner]);
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

/// The same surface, every triangle cut into four.
inline TriangleMesh quartered(TriangleMesh mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
        const auto [entry, isNew] =
            middles.try_emplace(std::minmax(i, j), std::uint32_t(mesh.vertices.size()));
        if (isNew) mesh.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]) / 2);
        return entry->second;
    };
    std::vector<Triangle> quarters;
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
        quarters.insert(quarters.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(quarters);
    return mesh;
}

/// Fisher and Yates; unlike std::shuffle the same everywhere.
template <typename T>
void shuffle(std::vector<T>& items, Random& random) {
    for (std::size_t i = items.size(); i > 1; --i)
        std::swap(items[i - 1], items[random.index(i)]);
}

/// The same surface with its vertices, its triangles and the first corner of each in another order.
inline TriangleMesh shuffled(const TriangleMesh& mesh, Random& random) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
        order.push_back(i);
    shuffle(order, random);
    TriangleMesh result = mesh;
    for (std::size_t i = 0; i < order.size(); ++i)
        result.vertices[order[i]] = mesh.vertices[i];
    for (Triangle& triangle : result.triangles) {
        for (std::uint32_t& corner : triangle)
            corner = order[corner];
        std::rotate(triangle.begin(), triangle.begin() + std::ptrdiff_t(random.index(3)), triangle.end());
    }
    shuffle(result.triangles, random);
    return result;
}

/// As it comes back from a file or an engine in single precision.
inline Vec3 throughFloat(const Vec3& point) {
    return point.cast<float>().cast<double>();
}

}  // namespace bullet_buoyancy::test
