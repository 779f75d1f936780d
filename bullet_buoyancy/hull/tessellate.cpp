#include "bullet_buoyancy/hull/tessellate.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

namespace {

using Index = std::uint32_t;

/// The 12 vertices (0, +-1, +-golden ratio), cyclically, and the 20 triangles between nearest neighbours.
TriangleMesh unitIcosahedron() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (double one : {-1.0, 1.0})
            for (double far : {-golden, golden}) {
                Vec3 vertex = Vec3::Zero();
                vertex[(axis + 1) % 3] = one;
                vertex[(axis + 2) % 3] = far;
                mesh.vertices.push_back(vertex.normalized());
            }
    const auto joined = [&](Index i, Index j) { return mesh.vertices[i].dot(mesh.vertices[j]) > 0.4; };
    for (Index a = 0; a < 12; ++a)
        for (Index b = a + 1; b < 12; ++b)
            for (Index c = b + 1; c < 12; ++c) {
                if (!joined(a, b) || !joined(b, c) || !joined(c, a)) continue;
                const bool outward = mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) > 0;
                mesh.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
            }
    return mesh;
}

void quarterOnUnitSphere(TriangleMesh& mesh) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index i, Index j) {
        const auto [entry, isNew] = middles.try_emplace(std::minmax(i, j), Index(mesh.vertices.size()));
        if (isNew) mesh.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]).normalized());
        return entry->second;
    };
    std::vector<Triangle> quarters;
    for (const Triangle& t : mesh.triangles) {
        const Index ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
        quarters.insert(quarters.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(quarters);
}

/// Axial coordinates of the rings: dense at the ends of each curved piece, where a sphere's profile is steep.
std::vector<double> ringCoordinates(const SolidOfRevolution& solid, int segments) {
    std::vector<double> rings{solid.profile.front().begin};
    for (const ProfilePiece& piece : solid.profile) {
        const int rings_in_piece = piece.c2 < 0 ? std::max(2, segments / 2) : 1;
        for (int i = 1; i <= rings_in_piece; ++i) {
            const double angle = pi * i / rings_in_piece;
            rings.push_back(piece.begin + (piece.end - piece.begin) * (1 - std::cos(angle)) / 2);
        }
    }
    return rings;
}

double radiusAt(const SolidOfRevolution& solid, double x) {
    for (const ProfilePiece& piece : solid.profile)
        if (x <= piece.end) return std::sqrt(std::max(0.0, piece.radiusSquared(x)));
    return std::sqrt(std::max(0.0, solid.profile.back().radiusSquared(x)));
}

}  // namespace

TriangleMesh tessellate(const Sphere& sphere, int levels) {
    TriangleMesh mesh = unitIcosahedron();
    for (int level = 0; level < levels; ++level)
        quarterOnUnitSphere(mesh);
    for (Vec3& vertex : mesh.vertices)
        vertex = sphere.centre + sphere.radius * vertex;
    return mesh;
}

TriangleMesh tessellate(const SolidOfRevolution& solid, int segments) {
    const std::vector<double> rings = ringCoordinates(solid, segments);
    const Vec3 e = solid.axis.unitOrthogonal(), b = solid.axis.cross(e);
    const auto count = Index(segments);
    TriangleMesh mesh;
    for (double x : rings)
        for (Index i = 0; i < count; ++i) {
            const double angle = 2 * pi * double(i) / segments;
            const Vec3 radial = std::cos(angle) * e + std::sin(angle) * b;
            mesh.vertices.push_back(solid.origin + x * solid.axis + radiusAt(solid, x) * radial);
        }
    const auto vertex = [&](Index ring, Index i) { return ring * count + i % count; };
    const auto lastRing = Index(rings.size() - 1);
    for (Index i = 0; i < count; ++i) {
        for (Index ring = 0; ring < lastRing; ++ring) {
            mesh.triangles.push_back({vertex(ring, i), vertex(ring, i + 1), vertex(ring + 1, i + 1)});
            mesh.triangles.push_back({vertex(ring, i), vertex(ring + 1, i + 1), vertex(ring + 1, i)});
        }
        mesh.triangles.push_back({vertex(0, 0), vertex(0, i + 1), vertex(0, i)});
        mesh.triangles.push_back({vertex(lastRing, 0), vertex(lastRing, i), vertex(lastRing, i + 1)});
    }
    return mesh;
}

}  // namespace bullet_buoyancy
