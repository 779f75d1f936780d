#include "bullet_buoyancy/hull/mesh_edges.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace bullet_buoyancy {

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh) {
    std::vector<HalfEdge> halfEdges;
    halfEdges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t from = mesh.triangles[t][side];
            const std::uint32_t to = mesh.triangles[t][(side + 1) % 3];
            halfEdges.push_back({std::min(from, to), std::max(from, to), t, from < to});
        }
    std::sort(halfEdges.begin(), halfEdges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return halfEdges;
}

std::size_t countOpenEdges(const TriangleMesh& mesh) {
    std::size_t open = 0;
    forEachEdge(sortedHalfEdges(mesh), [&](auto first, auto last) {
        const auto forward = std::count_if(first, last, [](const HalfEdge& h) { return h.forward; });
        open += std::size_t(std::abs(2 * forward - (last - first)));
    });
    return open;
}

}  // namespace bullet_buoyancy
