#include "scenes/faulty_meshes.h"

#include <cmath>
#include <limits>
#include <utility>

namespace bullet_buoyancy::scenes {

namespace {

constexpr double mass = 300;  // kg

/// Edges of 1 m about `centre`; outward.
TriangleMesh cube(const Vec3& centre = Vec3::Zero()) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back(
            centre + Vec3(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto offset = std::uint32_t(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

/// Without the two triangles of its top.
TriangleMesh openCube() {
    TriangleMesh mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
    return mesh;
}

TriangleMesh invertedCube() {
    TriangleMesh mesh = cube();
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

TriangleMesh doubledCube() {
    TriangleMesh mesh = cube();
    const std::vector<Triangle> once = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    return mesh;
}

/// Two cubes, half of each within the other.
TriangleMesh crossedCubes() {
    TriangleMesh mesh = cube({-0.25, 0, 0});
    append(mesh, cube({0.25, 0, 0}));
    return mesh;
}

/// One edge of the bottom is cut into slivers, a thousand times as long as they are wide and narrower by far.
TriangleMesh needleCube() {
    constexpr int needles = 200;
    TriangleMesh mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin());      // 0 2 1
    mesh.triangles.erase(mesh.triangles.begin() + 3);  // 0 1 4
    std::uint32_t before = 0;
    for (int i = 1; i <= needles; ++i) {
        const double along = std::pow(double(i) / needles, 3);  // the first is 1e-7 wide
        auto now = std::uint32_t(1);
        if (i < needles) {
            now = std::uint32_t(mesh.vertices.size());
            mesh.vertices.push_back(mesh.vertices[0] + along * Vec3::UnitX());
        }
        mesh.triangles.push_back({before, 2, now});
        mesh.triangles.push_back({before, now, 4});
        before = now;
    }
    return mesh;
}

/// Each triangle with vertices of its own, off by what single precision leaves of them.
TriangleMesh unweldedCube() {
    const TriangleMesh whole = cube();
    TriangleMesh mesh;
    for (const Triangle& triangle : whole.triangles) {
        const auto first = std::uint32_t(mesh.vertices.size());
        for (std::uint32_t corner : triangle)
            mesh.vertices.push_back(whole.vertices[corner] * (1 + 3e-8 * (double(first % 5) - 2)));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

TriangleMesh withStrayTriangle() {
    TriangleMesh mesh = cube();
    append(mesh, {{{0.1, 0, 0.1}, {0.2, 0, 0.1}, {0.1, 0.1, 0.2}}, {{0, 1, 2}}});
    return mesh;
}

TriangleMesh withNaN() {
    TriangleMesh mesh = cube();
    mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    return mesh;
}

TriangleMesh withWildIndex() {
    TriangleMesh mesh = cube();
    mesh.triangles[5][1] = 4711;
    return mesh;
}

}  // namespace

std::vector<FaultyMesh> faultyMeshes() {
    return {{"open", openCube()},
            {"inverted", invertedCube()},
            {"triangles twice", doubledCube()},
            {"through itself", crossedCubes(), 1.5},
            {"needles", needleCube()},
            {"unwelded", unweldedCube()},
            {"stray triangle", withStrayTriangle()},
            {"sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}}},
            {"NaN", withNaN()},
            {"wild index", withWildIndex()}};
}

FaultyResult floatFaulty(const FaultyMesh& faulty, Floater floater, const Stepping& stepping) {
    const HullResult made = makeHull(faulty.mesh);
    FaultyResult result{!made.hull, false, made.status.describe(), 0, 0, true};
    result.remarked = made.hull && result.remark != "ok";
    if (result.refused) return result;

    SceneDef sceneDef;
    sceneDef.floater = floater;
    FloatScene scene(sceneDef);
    const double density = scene.water().density();
    const auto shape = [] {
        return std::make_unique<btBoxShape>(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
    };
    Pose pose;
    pose.position.z() = 0.3;
    btRigidBody& body = scene.addBody(shape(), mass, pose);
    BodyDef def;
    def.hull = made.hull;
    scene.floatBody(body, def);
    scene.run(60, stepping.dt, stepping.substeps);
    const BodyReport report = scene.report(body);
    result.finite = isFinite(scene, body);
    result.balanceError = std::abs(report.submergedVolume * density / mass - 1);
    result.draftError =
        std::abs(heightAboveWater(body, scene.water()) - (0.5 - mass / (density * faulty.waterplane)));
    return result;
}

}  // namespace bullet_buoyancy::scenes
