#include "recording/shaded_mesh.h"

#include <Eigen/Geometry>
#include <cmath>

#include "bullet_buoyancy/hull/tessellate.h"

namespace bullet_buoyancy::recording {

namespace {

constexpr int sphereLevels = 3, solidSegments = 48;

/// Without the triangles of no size at the ends of a tessellated solid.
void append(TriangleMesh& mesh, const TriangleMesh& part) {
    const auto first = std::uint32_t(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles)
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
            mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// A corner of a triangle, at one vertex of a mesh.
struct Corner {
    std::size_t triangle;
    std::size_t place;  // 0 to 2
};

/// Twice their areas, outward.
std::vector<Vec3> areasOf(const TriangleMesh& mesh) {
    std::vector<Vec3> areas;
    areas.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        areas.push_back((b - a).cross(c - a));
    }
    return areas;
}

std::vector<std::vector<Corner>> cornersOf(const TriangleMesh& mesh) {
    std::vector<std::vector<Corner>> corners(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t place = 0; place < 3; ++place)
            corners[mesh.triangles[i][place]].push_back({i, place});
    return corners;
}

/// Of the faces about a vertex that are on the same side of all edges as one of them.
Vec3 smoothNormal(const Vec3& face, const std::vector<Corner>& around, const std::vector<Vec3>& areas,
                  double cosine) {
    Vec3 sum = Vec3::Zero();
    for (const Corner& corner : around) {
        const Vec3& area = areas[corner.triangle];
        if (area.dot(face) >= cosine * area.norm() * face.norm()) sum += area;
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3(Vec3::UnitZ());
}

}  // namespace

TriangleMesh trianglesOf(const Hull& hull) {
    TriangleMesh mesh = hull.mesh;
    for (const Sphere& sphere : hull.spheres)
        append(mesh, tessellate(sphere, sphereLevels));
    for (const SolidOfRevolution& solid : hull.solids)
        append(mesh, tessellate(solid, solidSegments));
    return mesh;
}

ShadedMesh shade(const TriangleMesh& mesh, double crease) {
    constexpr double same = 1 - 1e-9;  // cosine between normals of one vertex
    ShadedMesh shaded;
    shaded.triangles.resize(mesh.triangles.size());
    const std::vector<Vec3> areas = areasOf(mesh);
    const std::vector<std::vector<Corner>> corners = cornersOf(mesh);
    for (std::size_t vertex = 0; vertex < corners.size(); ++vertex) {
        const std::size_t first = shaded.vertices.size();
        for (const Corner& corner : corners[vertex]) {
            const Vec3 normal =
                smoothNormal(areas[corner.triangle], corners[vertex], areas, std::cos(crease));
            std::size_t index = first;
            while (index < shaded.normals.size() && shaded.normals[index].dot(normal) < same)
                ++index;
            if (index == shaded.normals.size()) {
                shaded.vertices.push_back(mesh.vertices[vertex]);
                shaded.normals.push_back(normal);
            }
            shaded.triangles[corner.triangle][corner.place] = std::uint32_t(index);
        }
    }
    return shaded;
}

}  // namespace bullet_buoyancy::recording
