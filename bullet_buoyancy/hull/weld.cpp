#include "bullet_buoyancy/hull/weld.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace bullet_buoyancy {

namespace {

constexpr std::uint32_t unset = std::uint32_t(-1);

/// For every vertex the one that stands for it: the first within the tolerance of it, in order along a
/// direction in which vertices seldom lie side by side, as they do along the axes.
std::vector<std::uint32_t> representatives(const std::vector<Vec3>& vertices, double tolerance) {
    const Vec3 direction = Vec3(0.4923, 0.6166, 0.6151).normalized();
    std::vector<double> place;
    for (const Vec3& vertex : vertices)
        place.push_back(direction.dot(vertex));
    std::vector<std::uint32_t> sorted(vertices.size());
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
        return std::tie(place[i], i) < std::tie(place[j], j);
    });

    std::vector<std::uint32_t> representative(vertices.size(), unset);
    for (auto i = sorted.begin(); i != sorted.end(); ++i) {
        if (representative[*i] != unset) continue;
        representative[*i] = *i;
        for (auto j = i + 1; j != sorted.end() && place[*j] - place[*i] <= tolerance; ++j) {
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
