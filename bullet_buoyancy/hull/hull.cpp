#include "bullet_buoyancy/hull/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/closed_solids.h"
#include "bullet_buoyancy/hull/find_overlaps.h"
#include "bullet_buoyancy/hull/mesh_repair.h"
#include "bullet_buoyancy/hull/tessellate.h"

namespace bullet_buoyancy {

namespace {

/// A bound on the time that one mesh of many solids takes: some tenths of a second.
constexpr std::size_t pairsCheckedInAMesh = 1000;

/// A mesh near enough to a part to tell whether parts overlap, and how its surface lies.
TriangleMesh roughMesh(const TriangleMesh& mesh) {
    return mesh;
}
TriangleMesh roughMesh(const Sphere& sphere) {
    return tessellate(sphere, 3);
}
TriangleMesh roughMesh(const SolidOfRevolution& solid) {
    return tessellate(solid, 48);
}

/// What a mesh may enclose by rounding alone of coordinates far from the origin, m^3.
double volumeOfRounding(const TriangleMesh& mesh, double size) {
    double farthest = 0;
    for (const Vec3& vertex : mesh.vertices)
        farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
    return std::numeric_limits<double>::epsilon() * farthest * size * size;
}

/// An open mesh may enclose less than nothing.
bool isSheet(const TriangleMesh& mesh, const VolumeMoments& moments) {
    const double size = meshSize(mesh);
    return moments.volume <= flatnessTolerance * std::pow(size, 3) + volumeOfRounding(mesh, size);
}

bool isSheet(const Sphere&, const VolumeMoments& moments) {
    return moments.volume <= 0;
}
bool isSheet(const SolidOfRevolution&, const VolumeMoments& moments) {
    return moments.volume <= 0;
}

bool isFinite(const VolumeMoments& moments) {
    return std::isfinite(moments.volume) && moments.firstMoment.allFinite() &&
           moments.secondMoment.allFinite();
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
    const auto offset = std::uint32_t(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles)
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

struct AddTo {
    Hull& hull;
    void operator()(const TriangleMesh& mesh) const { append(hull.mesh, mesh); }
    void operator()(const Sphere& sphere) const { hull.spheres.push_back(sphere); }
    void operator()(const SolidOfRevolution& solid) const { hull.solids.push_back(solid); }
};

void note(const Overlaps& overlaps, HullStatus& status) {
    status.overlappingPairs += overlaps.pairs;
    status.overlapVolume += overlaps.volume;
    status.uncheckedPairs += overlaps.uncheckedPairs;
}

/// Repairs one mesh and notes what was found.
void repairAndNote(TriangleMesh& mesh, HullStatus& status) {
    const MeshFindings findings = repairMesh(mesh);
    status.error = findings.error;
    status.weldedVertices += findings.weldedVertices;
    status.degenerateTriangles += findings.degenerateTriangles;
    status.duplicateTriangles += findings.duplicateTriangles;
    status.flippedTriangles += findings.flippedTriangles;
    status.openEdges += findings.openEdges;
    if (status.accepted() && mesh.triangles.empty()) status.error = HullError::noTriangles;
    if (findings.shells.size() > 1)
        note(findOverlaps(closedSolids(mesh, findings.shells), pairsCheckedInAMesh), status);
}

/// Repairs, checks and notes one part.
VolumeMoments takeIn(HullPart& part, HullStatus& status) {
    if (auto* mesh = std::get_if<TriangleMesh>(&part)) repairAndNote(*mesh, status);
    if (!status.accepted()) return {};
    const auto measure = [](const auto& p) { return volumeMoments(p); };
    const VolumeMoments moments = std::visit(measure, part);
    if (!isFinite(moments))
        status.error = HullError::notFinite;
    else if (std::visit([&](const auto& p) { return isSheet(p, moments); }, part))
        status.error = HullError::noVolume;
    return moments;
}

void noteOverlapsOfParts(const std::vector<HullPart>& parts, HullStatus& status) {
    if (parts.size() < 2) return;
    std::vector<TriangleMesh> meshes;
    for (const HullPart& part : parts)
        meshes.push_back(std::visit([](const auto& p) { return roughMesh(p); }, part));
    note(findOverlaps(meshes, meshes.size() * meshes.size()), status);
}

/// Box and sphere about the same centre.
void bound(Hull& hull) {
    Eigen::AlignedBox3d box;
    const auto extend = [&](const Vec3& centre, double radius) {
        box.extend(centre - Vec3::Constant(radius));
        box.extend(centre + Vec3::Constant(radius));
    };
    for (const Vec3& vertex : hull.mesh.vertices)
        box.extend(vertex);
    for (const Sphere& sphere : hull.spheres)
        extend(sphere.centre, sphere.radius);
    std::vector<Sphere> ends;
    for (const SolidOfRevolution& solid : hull.solids)
        for (const ProfilePiece& piece : solid.profile) {
            const double middle = (piece.begin + piece.end) / 2;
            // The widest radius of a piece is at an end or, on a sphere, at its centre.
            double widest = std::max(piece.radiusSquared(piece.begin), piece.radiusSquared(piece.end));
            if (piece.c2 < 0) widest = std::max(widest, piece.c0 - piece.c1 * piece.c1 / (4 * piece.c2));
            ends.push_back(
                {solid.origin + middle * solid.axis, std::hypot(std::sqrt(widest), piece.end - middle)});
            extend(ends.back().centre, ends.back().radius);
        }
    hull.halfExtents = box.sizes() / 2;
    Sphere& bounds = hull.bounds;
    bounds = {box.center(), 0};
    const auto reach = [&](const Vec3& centre, double radius) {
        bounds.radius = std::max(bounds.radius, (centre - bounds.centre).norm() + radius);
    };
    for (const Vec3& vertex : hull.mesh.vertices)
        reach(vertex, 0);
    for (const Sphere& sphere : hull.spheres)
        reach(sphere.centre, sphere.radius);
    for (const Sphere& end : ends)
        reach(end.centre, end.radius);
}

}  // namespace

HullResult makeHull(std::vector<HullPart> parts) {
    HullStatus status;
    if (parts.empty()) status.error = HullError::noTriangles;
    auto hull = std::make_shared<Hull>();
    for (HullPart& part : parts) {
        hull->moments += takeIn(part, status);
        if (!status.accepted()) return {nullptr, status};
        hull->surface += std::visit([](const auto& p) { return surfaceMoments(roughMesh(p)); }, part);
        hull->surfaceArea += std::visit([](const auto& p) { return surfaceArea(p); }, part);
        std::visit(AddTo{*hull}, part);
    }
    if (!status.accepted()) return {nullptr, status};
    noteOverlapsOfParts(parts, status);
    hull->meshIsClosed = status.openEdges == 0;
    bound(*hull);
    hull->packed = packMesh(hull->mesh, hull->bounds.centre);
    return {hull, status};
}

HullResult makeHull(TriangleMesh mesh) {
    std::vector<HullPart> parts;
    parts.emplace_back(std::move(mesh));
    return makeHull(std::move(parts));
}

}  // namespace bullet_buoyancy
