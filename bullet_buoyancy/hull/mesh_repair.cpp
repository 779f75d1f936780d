#include "bullet_buoyancy/hull/mesh_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/mesh_edges.h"
#include "bullet_buoyancy/hull/volume_moments.h"
#include "bullet_buoyancy/hull/weld.h"
#include "bullet_buoyancy/hull/winding_number.h"

namespace bullet_buoyancy {

namespace {

/// Triangles that hang together by edges which exactly two of them share.
struct Shell {
    std::vector<std::uint32_t> triangles;
    std::vector<bool> flipped;  // one a triangle of the shell
};

struct Neighbour {
    std::uint32_t triangle;
    bool agrees;  // in its winding
};

HullError check(const TriangleMesh& mesh) {
    for (const Vec3& vertex : mesh.vertices)
        if (!vertex.allFinite()) return HullError::notFinite;
    for (const Triangle& triangle : mesh.triangles)
        if (*std::max_element(triangle.begin(), triangle.end()) >= mesh.vertices.size())
            return HullError::badIndices;
    return HullError::none;
}

std::vector<std::vector<Neighbour>> manifoldNeighbours(const TriangleMesh& mesh) {
    std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
    forEachEdge(sortedHalfEdges(mesh), [&](auto first, auto last) {
        if (last - first != 2) return;
        const bool agrees = first[0].forward != first[1].forward;
        neighbours[first[0].triangle].push_back({first[1].triangle, agrees});
        neighbours[first[1].triangle].push_back({first[0].triangle, agrees});
    });
    return neighbours;
}

/// Walks every shell from its first triangle, flipping whoever disagrees with the one it was reached from;
/// the smaller side of a disagreement gives way.
std::vector<Shell> consistentShells(const TriangleMesh& mesh) {
    const std::vector<std::vector<Neighbour>> neighbours = manifoldNeighbours(mesh);
    std::vector<bool> reached(mesh.triangles.size(), false);
    std::vector<Shell> shells;
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (reached[seed]) continue;
        reached[seed] = true;
        Shell shell{{seed}, {false}};
        for (std::size_t i = 0; i < shell.triangles.size(); ++i)
            for (const Neighbour& neighbour : neighbours[shell.triangles[i]]) {
                if (reached[neighbour.triangle]) continue;
                reached[neighbour.triangle] = true;
                shell.triangles.push_back(neighbour.triangle);
                shell.flipped.push_back(shell.flipped[i] == neighbour.agrees);
            }
        if (std::count(shell.flipped.begin(), shell.flipped.end(), true) >
            std::ptrdiff_t(shell.flipped.size()) / 2)
            shell.flipped.flip();
        shells.push_back(std::move(shell));
    }
    return shells;
}

TriangleMesh meshOf(const TriangleMesh& mesh, const Shell& shell) {
    TriangleMesh part{{}, {}};
    part.vertices.reserve(3 * shell.triangles.size());
    for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
        const Triangle& triangle = mesh.triangles[shell.triangles[i]];
        const auto corner = std::uint32_t(part.vertices.size());
        for (std::uint32_t vertex : triangle)
            part.vertices.push_back(mesh.vertices[vertex]);
        part.triangles.push_back({corner, corner + 1 + shell.flipped[i], corner + 2 - shell.flipped[i]});
    }
    return part;
}

bool encloses(const TriangleMesh& shell, const Eigen::AlignedBox3d& box, const Vec3& point) {
    return box.contains(point) && std::abs(windingNumber(shell, point)) > 0.5;
}

Vec3 firstCentroid(const TriangleMesh& mesh) {
    return (mesh.vertices[0] + mesh.vertices[1] + mesh.vertices[2]) / 3;
}

/// Turns each outermost shell outward, and with it whatever it encloses.
void turnOutward(const TriangleMesh& mesh, std::vector<Shell>& shells) {
    std::vector<TriangleMesh> parts;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Shell& shell : shells) {
        parts.push_back(meshOf(mesh, shell));
        boxes.emplace_back();
        for (const Vec3& vertex : parts.back().vertices)
            boxes.back().extend(vertex);
    }
    for (std::size_t inner = 0; inner < shells.size(); ++inner) {
        std::size_t outermost = inner;
        for (std::size_t outer = 0; outer < shells.size(); ++outer) {
            const bool larger = boxes[outer].volume() > boxes[outermost].volume();
            if (larger && encloses(parts[outer], boxes[outer], firstCentroid(parts[inner])))
                outermost = outer;
        }
        if (volumeMoments(parts[outermost]).volume < 0) shells[inner].flipped.flip();
    }
}

std::size_t applyFlips(TriangleMesh& mesh, const std::vector<Shell>& shells) {
    std::size_t flips = 0;
    for (const Shell& shell : shells)
        for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
            if (!shell.flipped[i]) continue;
            Triangle& triangle = mesh.triangles[shell.triangles[i]];
            std::swap(triangle[1], triangle[2]);
            ++flips;
        }
    return flips;
}

}  // namespace

MeshFindings repairMesh(TriangleMesh& mesh) {
    MeshFindings findings;
    findings.error = check(mesh);
    if (findings.error != HullError::none) return findings;

    const WeldCounts welded = weld(mesh, weldTolerance * meshSize(mesh));
    findings.weldedVertices = welded.removedVertices;
    findings.degenerateTriangles = welded.removedTriangles;

    std::vector<Shell> shells = consistentShells(mesh);
    turnOutward(mesh, shells);
    findings.flippedTriangles = applyFlips(mesh, shells);
    findings.openEdges = countOpenEdges(mesh);
    return findings;
}

double meshSize(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices)
        box.extend(vertex);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace bullet_buoyancy
