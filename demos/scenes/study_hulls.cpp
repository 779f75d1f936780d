#include "scenes/study_hulls.h"

#include "bullet_buoyancy/hull/convex_hull.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "scenes/random_numbers.h"
#include "scenes/wigley_hull.h"

namespace bullet_buoyancy::scenes {

namespace {

const Vec3 semiAxes(0.6, 0.5, 0.4);  // m, of the ellipsoids

NamedHull hullOf(const std::string& name, HullPart part) {
    return {name, makeHull(std::vector<HullPart>{std::move(part)}).hull};
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
    const auto offset = std::uint32_t(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles)
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

}  // namespace

TriangleMesh boxMesh(const Vec3& size) {
    TriangleMesh mesh;
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            for (double z : {-0.5, 0.5})
                mesh.vertices.push_back(size.cwiseProduct(Vec3(x, y, z)));
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                      {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    return mesh;
}

TriangleMesh bumpyMesh(int levels) {
    TriangleMesh mesh = tessellate(Sphere{Vec3::Zero(), 1}, levels);
    for (Vec3& vertex : mesh.vertices) {
        const Vec3 u = vertex;
        const double radius = 1 + 0.5 * u.x() * u.y() * u.z() + 0.1 * u.x() * (u.y() - u.z());
        vertex = radius * semiAxes.cwiseProduct(u);
    }
    return mesh;
}

TriangleMesh pointsHull(int points) {
    RandomNumbers random(1);
    std::vector<Vec3> cloud;
    while (cloud.size() < std::size_t(points)) {
        const Vec3 direction = random.inCube(1);
        const double length = direction.norm();
        if (length > 0.1 && length < 1) cloud.push_back(semiAxes.cwiseProduct(direction) / length);
    }
    return convexHull(cloud);
}

TriangleMesh asMesh(const Hull& hull) {
    TriangleMesh mesh = hull.mesh;
    for (const Sphere& sphere : hull.spheres)
        append(mesh, tessellate(sphere, 2));
    for (const SolidOfRevolution& solid : hull.solids)
        append(mesh, tessellate(solid, 12));
    return mesh;
}

std::vector<NamedHull> hullsOfAllKinds() {
    const Vec3 cap(0.3, 0, 0);
    std::vector<NamedHull> hulls{
        hullOf("box", boxMesh({1, 0.8, 0.6})), hullOf("sphere", Sphere{Vec3::Zero(), 0.5}),
        hullOf("capsule", makeTaperedCapsule(-cap, 0.3, cap, 0.3)),
        hullOf("hull of 32 points", pointsHull(32)), hullOf("hull of 256 points", pointsHull(256))};
    for (int levels = 2; levels <= 6; ++levels)
        hulls.push_back(hullOf("mesh", bumpyMesh(levels)));
    hulls.push_back(hullOf("Wigley hull", wigleyMesh()));
    return hulls;
}

}  // namespace bullet_buoyancy::scenes
