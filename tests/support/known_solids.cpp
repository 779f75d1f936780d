#include "support/known_solids.h"

#include <cmath>
#include <stdexcept>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/convex_hull.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

namespace {

using Index = std::uint32_t;

void addQuad(TriangleMesh& mesh, Index a, Index b, Index c, Index d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

TriangleMesh randomConvexHull(int points, std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec3> cloud;
    for (int i = 0; i < points; ++i)
        cloud.push_back(0.5 * random.direction());
    return convexHull(cloud);
}

TriangleMesh boxWithCavity() {
    TriangleMesh mesh = boxMesh({1, 1, 1}), cavity = boxMesh({0.5, 0.4, 0.3}, {0.1, 0, 0.1});
    const auto offset = Index(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
    for (const Triangle& t : cavity.triangles)
        mesh.triangles.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
    return mesh;
}

}  // namespace

TriangleMesh boxMesh(const Vec3& size, const Vec3& centre) {
    TriangleMesh mesh;
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            for (double z : {-0.5, 0.5})
                mesh.vertices.push_back(centre + size.cwiseProduct(Vec3(x, y, z)));
    addQuad(mesh, 0, 1, 3, 2);  // -x
    addQuad(mesh, 4, 6, 7, 5);  // +x
    addQuad(mesh, 0, 4, 5, 1);  // -y
    addQuad(mesh, 2, 3, 7, 6);  // +y
    addQuad(mesh, 0, 2, 6, 4);  // -z
    addQuad(mesh, 1, 5, 7, 3);  // +z
    return mesh;
}

TriangleMesh ringMesh(double inner, double outer, double halfHeight, int segments) {
    TriangleMesh mesh;
    const auto count = Index(segments);
    for (Index i = 0; i < count; ++i) {
        const double angle = 2 * pi * i / segments;
        const Vec3 radial(std::cos(angle), std::sin(angle), 0);
        for (const auto& [radius, height] : {std::pair(inner, -halfHeight), std::pair(outer, -halfHeight),
                                             std::pair(outer, halfHeight), std::pair(inner, halfHeight)})
            mesh.vertices.push_back(radius * radial + height * Vec3::UnitZ());
    }
    for (Index i = 0; i < count; ++i)
        for (Index k = 0; k < 4; ++k) {
            const Index next = (i + 1) % count;
            addQuad(mesh, 4 * i + k, 4 * next + k, 4 * next + (k + 1) % 4, 4 * i + (k + 1) % 4);
        }
    return mesh;
}

TriangleMesh wigleyMesh(double length, double beam, double draft, int stations, int waterlines) {
    TriangleMesh mesh;
    const auto columns = Index(stations + 1), rows = Index(waterlines + 1);
    for (double side : {1.0, -1.0})
        for (Index i = 0; i < columns; ++i)
            for (Index j = 0; j < rows; ++j) {
                const double u = -1 + 2.0 * i / stations, w = 1 - 1.0 * j / waterlines;
                mesh.vertices.push_back(
                    {u * length / 2, side * beam / 2 * (1 - u * u) * (1 - w * w), -w * draft});
            }
    const auto port = [&](Index i, Index j) { return i * rows + j; };
    const auto starboard = [&](Index i, Index j) { return columns * rows + i * rows + j; };
    for (Index i = 0; i + 1 < columns; ++i) {
        for (Index j = 0; j + 1 < rows; ++j) {
            addQuad(mesh, port(i, j), port(i, j + 1), port(i + 1, j + 1), port(i + 1, j));
            addQuad(mesh, starboard(i, j), starboard(i + 1, j), starboard(i + 1, j + 1), starboard(i, j + 1));
        }
        addQuad(mesh, port(i, rows - 1), starboard(i, rows - 1), starboard(i + 1, rows - 1),
                port(i + 1, rows - 1));
    }
    return mesh;
}

std::shared_ptr<const Hull> hullOf(std::vector<HullPart> parts) {
    HullResult result = makeHull(std::move(parts));
    if (!result.hull) throw std::runtime_error(result.status.describe());
    return result.hull;
}

std::shared_ptr<const Hull> hullOf(TriangleMesh mesh) {
    return hullOf(std::vector<HullPart>{std::move(mesh)});
}

std::vector<NamedHull> polyhedra() {
    return {
        {"box", hullOf(boxMesh({1.0, 0.8, 0.6}))},
        {"off-centre box", hullOf(boxMesh({1.0, 0.8, 0.6}, {0.3, -0.2, 0.5}))},
        {"plank", hullOf(boxMesh({3.0, 0.3, 0.03}))},
        {"tetrahedron", hullOf(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}))},
        {"convex hull of 64 points", hullOf(randomConvexHull(64, 7))},
        {"icosphere of 320 triangles", hullOf(tessellate(Sphere{Vec3::Zero(), 0.5}, 2))},
        {"ring", hullOf(ringMesh(0.3, 0.6, 0.2, 12))},
        {"box with a cavity", hullOf(boxWithCavity())},
        {"two boxes", hullOf(std::vector<HullPart>{boxMesh({1, 0.3, 0.3}, {0, 0.5, 0}),
                                                   boxMesh({1, 0.3, 0.3}, {0, -0.5, 0})})},
        {"Wigley hull", hullOf(wigleyMesh(1.0, 0.3, 0.2, 12, 6))},
    };
}

std::vector<NamedHull> smoothSolids() {
    const Vec3 axis = Vec3(1, 2, -2) / 3;
    const auto one = [](HullPart part) { return hullOf(std::vector<HullPart>{std::move(part)}); };
    return {
        {"sphere", one(Sphere{{0.1, -0.2, 0.3}, 0.5})},
        {"capsule", one(makeTaperedCapsule(-0.4 * axis, 0.3, 0.4 * axis, 0.3))},
        {"tapered capsule", one(makeTaperedCapsule(-0.4 * axis, 0.4, 0.4 * axis, 0.15))},
        {"cylinder", one(makeCylinder({0.1, 0, 0}, Vec3::UnitY(), 0.4, 0.5))},
        {"disc", one(makeCylinder(Vec3::Zero(), axis, 0.6, 0.05))},
        {"rod", one(makeCylinder(Vec3::Zero(), Vec3::UnitZ(), 0.03, 1.0))},
        {"cone", one(makeCone(-0.4 * axis, axis, 0.4, 0.9))},
    };
}

}  // namespace bullet_buoyancy::test
