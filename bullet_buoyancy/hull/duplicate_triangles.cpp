#include "bullet_buoyancy/hull/duplicate_triangles.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "bullet_buoyancy/hull/mesh_edges.h"

namespace bullet_buoyancy {

namespace {

/// The same for triangles of the same vertices in the same winding.
Triangle lowestFirst(Triangle triangle) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    return triangle;
}

/// For every triangle the first that is the same.
std::vector<std::uint32_t> firstOfTheSame(const std::vector<Triangle>& triangles) {
    std::vector<Triangle> keys;
    keys.reserve(triangles.size());
    for (const Triangle& triangle : triangles)
        keys.push_back(lowestFirst(triangle));
    std::vector<std::uint32_t> sorted(triangles.size());
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::sort(sorted.begin(), sorted.end(),
              [&](std::uint32_t i, std::uint32_t j) { return std::tie(keys[i], i) < std::tie(keys[j], j); });
    std::vector<std::uint32_t> first(triangles.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const bool repeats = i > 0 && keys[sorted[i]] == keys[sorted[i - 1]];
        first[sorted[i]] = repeats ? first[sorted[i - 1]] : sorted[i];
    }
    return first;
}

/// Triangles that hang together, by one that stands for them.
class Patches {
public:
    explicit Patches(std::size_t count) : m_leader(count) { std::iota(m_leader.begin(), m_leader.end(), 0u); }
    std::uint32_t find(std::uint32_t triangle) {
        while (m_leader[triangle] != triangle)
            triangle = m_leader[triangle] = m_leader[m_leader[triangle]];
        return triangle;
    }
    void unite(std::uint32_t a, std::uint32_t b) { m_leader[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> m_leader;
};

/// By how much the number of edges with an odd number of sides changes at one edge when its repeated
/// triangles go. Where all are there equally often, the surface lies there as a whole, rim or not.
template <typename Side>
int changeOfOddEdges(Side begin, Side end, const std::vector<std::uint32_t>& first) {
    std::vector<std::uint32_t> sides;
    for (Side side = begin; side != end; ++side)
        sides.push_back(first[side->triangle]);
    std::sort(sides.begin(), sides.end());
    int left = 0;
    bool equallyOften = true;
    const auto timesOfFirst = std::upper_bound(sides.begin(), sides.end(), sides.front()) - sides.begin();
    for (auto same = sides.begin(); same != sides.end(); ++left) {
        const auto next = std::upper_bound(same, sides.end(), *same);
        equallyOften = equallyOften && next - same == timesOfFirst;
        same = next;
    }
    return equallyOften ? 0 : left % 2 - int(sides.size() % 2);
}

}  // namespace

std::size_t removeDuplicateTriangles(TriangleMesh& mesh) {
    const std::vector<std::uint32_t> first = firstOfTheSame(mesh.triangles);
    const auto count = std::uint32_t(mesh.triangles.size());
    const auto repeats = [&](std::uint32_t triangle) { return first[triangle] != triangle; };
    bool any = false;
    for (std::uint32_t t = 0; t < count; ++t)
        any = any || repeats(t);
    if (!any) return 0;

    const std::vector<HalfEdge> halfEdges = sortedHalfEdges(mesh);
    Patches patches(count);
    const auto forRepeatsAt = [&](auto begin, auto end, const auto& visit) {
        for (auto side = begin; side != end; ++side)
            if (repeats(side->triangle)) visit(side->triangle);
    };
    forEachEdge(halfEdges, [&](auto begin, auto end) {
        std::uint32_t last = count;
        forRepeatsAt(begin, end, [&](std::uint32_t t) {
            if (last != count) patches.unite(last, t);
            last = t;
        });
    });
    std::vector<int> opened(count, 0);
    forEachEdge(halfEdges, [&](auto begin, auto end) {
        const auto repeated = std::find_if(begin, end, [&](const auto& s) { return repeats(s.triangle); });
        if (repeated != end) opened[patches.find(repeated->triangle)] += changeOfOddEdges(begin, end, first);
    });

    std::vector<Triangle> kept;
    for (std::uint32_t t = 0; t < count; ++t)
        if (!repeats(t) || opened[patches.find(t)] > 0) kept.push_back(mesh.triangles[t]);
    mesh.triangles = std::move(kept);
    return count - mesh.triangles.size();
}

}  // namespace bullet_buoyancy
