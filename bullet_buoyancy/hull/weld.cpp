#include "bullet_buoyancy/hull/weld.h"

#include <algorithm>
#include <numeric>

namespace bullet_buoyancy {

namespace {

constexpr std::uint32_t unset = std::uint32_t(-1);

/// For every vertex the one that stands for it: the first within the tolerance of it, in lexicographical
/// order.
std::vector<std::uint32_t> representatives(const std::vector<Vec3>& vertices, double tolerance) {
    std::vector<std::uint32_t> sorted(vertices.size());
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
        const Vec3 &a = vertices[i], &b = vertices[j];
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    });

    std::vector<std::uint32_t> representative(vertices.size(), unset);
    for (auto i = sorted.begin(); i != sorted.end(); ++i) {
        if (representative[*i] != unset) continue;
        representative[*i] = *i;
        for (auto j = i + 1; j != sorted.end() && vertices[*j].x() - vertices[*i].x() <= tolerance; ++j) {
            const bool near = (vertices[*j] - vertices[*i]).norm() <= tolerance;
            if (near && representative[*j] == unset) representative[*j] = *i;
        }
    }
    return representative;
}

void keepUsedVertices(TriangleMesh& mesh) {
    std::vector<std::uint32_t> newIndex(mesh.vertices.size(), unset);
    std::vector<Vec3> used;
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) {
            if (newIndex[corner] == unset) {
                newIndex[corner] = std::uint32_t(used.size());
                used.push_back(mesh.vertices[corner]);
            }
            corner = newIndex[corner];
        }
    mesh.vertices = std::move(used);
}

}  // namespace

WeldCounts weld(TriangleMesh& mesh, double tolerance) {
    const std::size_t verticesBefore = mesh.vertices.size();
    const std::size_t trianglesBefore = mesh.triangles.size();

    const std::vector<std::uint32_t> representative = representatives(mesh.vertices, tolerance);
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle)
            corner = representative[corner];

    const auto collapsed = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
    mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), collapsed),
                         mesh.triangles.end());
    keepUsedVertices(mesh);
    return {verticesBefore - mesh.vertices.size(), trianglesBefore - mesh.triangles.size()};
}

}  // namespace bullet_buoyancy
