#include "bullet_buoyancy/bullet/draw_floating_body.h"

#include <Eigen/Core>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hydrostatics/clip_triangle.h"

namespace bullet_buoyancy {

namespace {

constexpr int sphereLevels = 2;
constexpr int solidSegments = 24;
constexpr double markerShare = 0.02;  // of the body's length

const btVector3 waterlineColour(0, 0.3f, 1);
const btVector3 wettedColour(0.2f, 0.6f, 0.8f);
const btVector3 massColour(1, 1, 0);
const btVector3 buoyancyColour(0, 1, 1);

struct Sea {
    const WaterField& water;
    double time;
};

/// Of each vertex, m; above zero under water.
Eigen::ArrayXd depths(const TriangleMesh& mesh, const Pose& pose, const Sea& sea) {
    const auto count = Eigen::Index(mesh.vertices.size());
    Eigen::ArrayX2d points(count, 2);
    Eigen::ArrayXd heights(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec3 world = pose.position + pose.orientation * mesh.vertices[std::size_t(i)];
        const Vec3 point = sea.water.frame().pointFromWorld(world);
        points.row(i) = point.head<2>().transpose().array();
        heights[i] = point.z();
    }
    Eigen::ArrayX3d samples(count, 3);
    sea.water.sampleSurface(points, sea.time, samples);
    return samples.col(0) - heights;
}

/// The surface is taken for linear over each triangle.
void drawWetMesh(btIDebugDraw& drawer, const TriangleMesh& mesh, const Pose& pose, const Sea& sea) {
    const Eigen::ArrayXd depth = depths(mesh, pose, sea);
    const auto corner = [&](std::uint32_t index) {
        return DepthPoint{mesh.vertices[index], depth[Eigen::Index(index)]};
    };
    const auto line = [&](const DepthPoint& from, const DepthPoint& to) {
        const bool atSurface = from.depth == 0 && to.depth == 0;
        drawer.drawLine(toBullet(pose.position + pose.orientation * from.position),
                        toBullet(pose.position + pose.orientation * to.position),
                        atSurface ? waterlineColour : wettedColour);
    };
    for (const Triangle& t : mesh.triangles)
        visitWetPart(corner(t[0]), corner(t[1]), corner(t[2]),
                     [&](const DepthPoint& a, const DepthPoint& b, const DepthPoint& c) {
                         line(a, b);
                         line(b, c);
                         line(c, a);
                     });
}

}  // namespace

void drawFloatingBody(btIDebugDraw& drawer, const FloatingBody& floating, const WaterField& water,
                      double time) {
    const Pose pose = toPose(floating.body().getWorldTransform());
    const Sea sea{water, time};
    const Hull& hull = floating.hull();
    drawWetMesh(drawer, hull.mesh, pose, sea);
    for (const Sphere& sphere : hull.spheres)
        drawWetMesh(drawer, tessellate(sphere, sphereLevels), pose, sea);
    for (const SolidOfRevolution& solid : hull.solids)
        drawWetMesh(drawer, tessellate(solid, solidSegments), pose, sea);

    const BodyReport report = floating.report(water.frame());
    const auto marker = btScalar(2 * hull.bounds.radius * markerShare);
    drawer.drawSphere(toBullet(pose.position), marker, massColour);
    if (report.wetFraction <= 0) return;
    drawer.drawSphere(report.centreOfBuoyancyWorld, marker, buoyancyColour);
    const btScalar forceOfWholeHull = report.forceWorld.length() / btScalar(report.wetFraction);
    if (forceOfWholeHull <= 0) return;
    drawer.drawLine(report.centreOfBuoyancyWorld,
                    report.centreOfBuoyancyWorld +
                        btScalar(2 * hull.bounds.radius) / forceOfWholeHull * report.forceWorld,
                    buoyancyColour);
}

}  // namespace bullet_buoyancy
