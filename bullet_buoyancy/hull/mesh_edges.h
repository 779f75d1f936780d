#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// One side of a triangle: the edge between two vertices, and which way the triangle runs along it.
struct HalfEdge {
    std::uint32_t low, high;  ///< vertices of the edge, low < high
    std::uint32_t triangle;
    bool forward;  ///< the triangle runs from low to high

    bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// All sides of all triangles, those of one edge next to each other.
std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh);

/// Calls `visit(first, last)` with the half-edges of each edge.
template <typename Visit>
void forEachEdge(const std::vector<HalfEdge>& halfEdges, const Visit& visit) {
    for (auto first = halfEdges.begin(); first != halfEdges.end();) {
        auto last = first + 1;
        while (last != halfEdges.end() && last->sameEdge(*first))
            ++last;
        visit(first, last);
        first = last;
    }
}

/// Triangle sides that no side in the opposite direction balances: 0 means that the surface has no boundary.
std::size_t countOpenEdges(const TriangleMesh& mesh);

}  // namespace bullet_buoyancy
