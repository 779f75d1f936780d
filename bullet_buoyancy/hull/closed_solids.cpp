#include "bullet_buoyancy/hull/closed_solids.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/mesh_edges.h"
#include "bullet_buoyancy/hull/mesh_repair.h"
#include "bullet_buoyancy/hull/volume_moments.h"
#include "bullet_buoyancy/hull/winding_number.h"

namespace bullet_buoyancy {

namespace {

struct ClosedShell {
    TriangleMesh mesh;
    double volume;  // below 0 if it faces inward
    Eigen::AlignedBox3d box;
    std::vector<std::uint32_t> triangles;  // of the whole mesh
};

/// With vertices of its own.
TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    TriangleMesh part;
    std::map<std::uint32_t, std::uint32_t> newIndex;
    for (std::uint32_t t : triangles) {
        Triangle triangle = mesh.triangles[t];
        for (std::uint32_t& corner : triangle) {
            const auto [entry, isNew] = newIndex.try_emplace(corner, std::uint32_t(part.vertices.size()));
            if (isNew) part.vertices.push_back(mesh.vertices[corner]);
            corner = entry->second;
        }
        part.triangles.push_back(triangle);
    }
    return part;
}

std::vector<ClosedShell> closedShells(const TriangleMesh& mesh,
                                      const std::vector<std::vector<std::uint32_t>>& shells) {
    std::vector<ClosedShell> closed;
    for (const std::vector<std::uint32_t>& triangles : shells) {
        ClosedShell shell{partOf(mesh, triangles), 0, {}, triangles};
        if (countOpenEdges(shell.mesh) > 0) continue;
        shell.volume = volumeMoments(shell.mesh).volume;
        if (std::abs(shell.volume) <= flatnessTolerance * std::pow(meshSize(shell.mesh), 3)) continue;
        for (const Vec3& vertex : shell.mesh.vertices)
            shell.box.extend(vertex);
        closed.push_back(std::move(shell));
    }
    return closed;
}

/// The smallest outward shell round a cavity, or none.
const ClosedShell* shellRound(const ClosedShell& cavity, const std::vector<ClosedShell>& shells) {
    const ClosedShell* smallest = nullptr;
    for (const ClosedShell& shell : shells) {
        if (shell.volume < 0 || (smallest && smallest->volume <= shell.volume)) continue;
        if (shell.box.intersects(cavity.box) && encloses(shell.mesh, cavity.mesh)) smallest = &shell;
    }
    return smallest;
}

}  // namespace

std::vector<TriangleMesh> closedSolids(const TriangleMesh& mesh,
                                       const std::vector<std::vector<std::uint32_t>>& shells) {
    const std::vector<ClosedShell> closed = closedShells(mesh, shells);
    std::map<const ClosedShell*, std::vector<std::uint32_t>> cavities;
    for (const ClosedShell& shell : closed) {
        if (shell.volume > 0) continue;
        std::vector<std::uint32_t>& within = cavities[shellRound(shell, closed)];
        within.insert(within.end(), shell.triangles.begin(), shell.triangles.end());
    }
    std::vector<TriangleMesh> solids;
    for (const ClosedShell& shell : closed) {
        if (shell.volume < 0) continue;
        std::vector<std::uint32_t> triangles = shell.triangles;
        const std::vector<std::uint32_t>& within = cavities[&shell];
        triangles.insert(triangles.end(), within.begin(), within.end());
        solids.push_back(partOf(mesh, triangles));
    }
    return solids;
}

}  // namespace bullet_buoyancy
