#include "bullet_buoyancy/hull/mesh_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/duplicate_triangles.h"
#include "bullet_buoyancy/hull/mesh_edges.h"
#include "bullet_buoyancy/hull/volume_moments.h"
#include "bullet_buoyancy/hull/weld.h"
#include "bullet_buoyancy/hull/winding_number.h"

namespace bullet_buoyancy {

namespace {

/// Triangles that hang together: first by edges which exactly two of them share, then by any edge at which
/// they are open.
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
    if (!std::isfinite(meshSize(mesh))) return HullError::notFinite;
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

/// Two shells that meet at an edge of more than two triangles and are open there.
struct Seam {
    std::size_t shell, other;
    int agreement;  // above 0 if they run along it in opposite directions
};

std::vector<Seam> findSeams(const TriangleMesh& mesh, const std::vector<Shell>& shells) {
    std::vector<std::size_t> shellOf(mesh.triangles.size());
    std::vector<bool> flipped(mesh.triangles.size());
    for (std::size_t s = 0; s < shells.size(); ++s)
        for (std::size_t i = 0; i < shells[s].triangles.size(); ++i) {
            shellOf[shells[s].triangles[i]] = s;
            flipped[shells[s].triangles[i]] = shells[s].flipped[i];
        }
    std::vector<Seam> seams;
    forEachEdge(sortedHalfEdges(mesh), [&](auto first, auto last) {
        if (last - first <= 2) return;
        // Of each shell: its sides that run forward less those that run back.
        std::map<std::size_t, int> balance;
        for (auto side = first; side != last; ++side)
            balance[shellOf[side->triangle]] += side->forward != flipped[side->triangle] ? 1 : -1;
        for (auto i = balance.begin(); i != balance.end(); ++i)
            for (auto j = std::next(i); j != balance.end(); ++j)
                if (i->second != 0 && j->second != 0)
                    seams.push_back({i->first, j->first, -i->second * j->second});
    });
    return seams;
}

/// Turns shells round for as long as that balances their seams better: what already balances stays as it is.
void balanceSeams(const std::vector<Seam>& seams, std::vector<Shell>& shells) {
    std::vector<bool> turned(shells.size(), false);
    while (true) {
        std::vector<int> agreement(shells.size(), 0);
        for (const Seam& seam : seams) {
            const int now = turned[seam.shell] == turned[seam.other] ? seam.agreement : -seam.agreement;
            agreement[seam.shell] += now;
            agreement[seam.other] += now;
        }
        const auto worst = std::min_element(agreement.begin(), agreement.end());
        if (worst == agreement.end() || *worst >= 0) return;
        const auto shell = std::size_t(worst - agreement.begin());
        turned[shell] = !turned[shell];
        shells[shell].flipped.flip();
    }
}

/// Shells that meet at seams become one: a patch between seams does not enclose what would tell its outside.
std::vector<Shell> joinedAtSeams(const TriangleMesh& mesh, std::vector<Shell> shells) {
    const std::vector<Seam> seams = findSeams(mesh, shells);
    balanceSeams(seams, shells);
    std::vector<std::size_t> leader(shells.size());
    for (std::size_t s = 0; s < shells.size(); ++s)
        leader[s] = s;
    const auto find = [&](std::size_t s) {
        while (leader[s] != s)
            s = leader[s] = leader[leader[s]];
        return s;
    };
    for (const Seam& seam : seams) {
        const std::size_t a = find(seam.shell), b = find(seam.other);
        leader[std::max(a, b)] = std::min(a, b);
    }

    std::vector<Shell> joined;
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (find(s) == s) continue;
        Shell& whole = shells[find(s)];
        whole.triangles.insert(whole.triangles.end(), shells[s].triangles.begin(), shells[s].triangles.end());
        whole.flipped.insert(whole.flipped.end(), shells[s].flipped.begin(), shells[s].flipped.end());
    }
    for (std::size_t s = 0; s < shells.size(); ++s)
        if (find(s) == s) joined.push_back(std::move(shells[s]));
    return joined;
}

/// With its own vertices only: what an open shell encloses is told about their mean.
TriangleMesh meshOf(const TriangleMesh& mesh, const Shell& shell) {
    std::vector<std::uint32_t> used;
    used.reserve(3 * shell.triangles.size());
    for (std::uint32_t triangle : shell.triangles)
        used.insert(used.end(), mesh.triangles[triangle].begin(), mesh.triangles[triangle].end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    TriangleMesh part{{}, {}};
    for (std::uint32_t vertex : used)
        part.vertices.push_back(mesh.vertices[vertex]);
    for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
        Triangle triangle = mesh.triangles[shell.triangles[i]];
        for (std::uint32_t& corner : triangle)
            corner = std::uint32_t(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
        if (shell.flipped[i]) std::swap(triangle[1], triangle[2]);
        part.triangles.push_back(triangle);
    }
    return part;
}

/// Flat shells face neither way, whatever rounding makes of their volume.
bool facesInward(const TriangleMesh& mesh) {
    return volumeMoments(mesh).volume < -flatnessTolerance * std::pow(meshSize(mesh), 3);
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
            if (larger && boxes[outer].intersects(boxes[inner]) && encloses(parts[outer], parts[inner]))
                outermost = outer;
        }
        if (facesInward(parts[outermost])) shells[inner].flipped.flip();
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

/// Makes neighbours agree and turns what is outermost outward.
void orient(TriangleMesh& mesh, MeshFindings& findings) {
    std::vector<Shell> shells = joinedAtSeams(mesh, consistentShells(mesh));
    turnOutward(mesh, shells);
    findings.flippedTriangles += applyFlips(mesh, shells);
    findings.shells.clear();
    for (Shell& shell : shells)
        findings.shells.push_back(std::move(shell.triangles));
}

}  // namespace

MeshFindings repairMesh(TriangleMesh& mesh) {
    MeshFindings findings;
    findings.error = check(mesh);
    if (findings.error != HullError::none) return findings;

    const WeldCounts welded = weld(mesh, weldTolerance * meshSize(mesh));
    findings.weldedVertices = welded.removedVertices;
    findings.degenerateTriangles = welded.removedTriangles;

    findings.duplicateTriangles = removeDuplicateTriangles(mesh);
    orient(mesh, findings);
    // Copies that disagreed in their winding are the same only now.
    if (const std::size_t duplicates = removeDuplicateTriangles(mesh)) {
        findings.duplicateTriangles += duplicates;
        orient(mesh, findings);
    }
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
