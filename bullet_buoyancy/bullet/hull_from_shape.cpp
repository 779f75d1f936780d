#include "bullet_buoyancy/bullet/hull_from_shape.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/read_striding_mesh.h"
#include "bullet_buoyancy/hull/convex_hull.h"
#include "bullet_buoyancy/hull/place_part.h"
#include "bullet_buoyancy/hull/tessellate.h"

namespace bullet_buoyancy {

namespace {

constexpr int sphereLevels = 4;     // 5,120 triangles on each sphere of a multi-sphere
constexpr int minkowskiLevels = 3;  // 1,280 triangles on smooth members of a Minkowski sum
constexpr int minkowskiSegments = 48;

/// Parts of a shape in its frame, or why it has none.
struct Reading {
    std::vector<HullPart> parts;
    HullStatus status;

    Reading() = default;
    Reading(HullPart part) : parts{std::move(part)} {}
    Reading(HullError error, const char* reason = "") {
        status.error = error;
        status.reason = reason;
    }
    bool failed() const { return !status.accepted(); }
};

Reading read(const btCollisionShape& shape);

Reading refused(const char* reason) {
    return {HullError::unsupportedShape, reason};
}

template <typename Shape>
const Shape& as(const btCollisionShape& shape) {
    return static_cast<const Shape&>(shape);
}

Reading hullOf(const std::vector<Vec3>& points) {
    if (!std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); }))
        return HullError::notFinite;
    TriangleMesh mesh = convexHull(points);
    if (mesh.triangles.empty()) return HullError::flatPoints;
    return HullPart(std::move(mesh));
}

Reading readBox(const btBoxShape& box) {
    const Vec3 half = toEigen(box.getHalfExtentsWithMargin());
    std::vector<Vec3> corners;
    for (double x : {-1.0, 1.0})
        for (double y : {-1.0, 1.0})
            for (double z : {-1.0, 1.0})
                corners.push_back(half.cwiseProduct(Vec3(x, y, z)));
    return hullOf(corners);
}

Reading readConvexHull(const btConvexHullShape& hull) {
    std::vector<Vec3> points;
    for (int i = 0; i < hull.getNumPoints(); ++i)
        points.push_back(toEigen(hull.getScaledPoint(i)));
    return hullOf(points);
}

Reading readPointCloud(const btConvexPointCloudShape& cloud) {
    std::vector<Vec3> points;
    for (int i = 0; i < cloud.getNumPoints(); ++i)
        points.push_back(toEigen(cloud.getScaledPoint(i)));
    return hullOf(points);
}

Reading readPolyhedron(const btPolyhedralConvexShape& polyhedron) {
    std::vector<Vec3> points;
    for (int i = 0; i < polyhedron.getNumVertices(); ++i) {
        btVector3 vertex;
        polyhedron.getVertex(i, vertex);
        points.push_back(toEigen(vertex));
    }
    return hullOf(points);
}

/// Of a round shape: negative where it was mirrored, or made so, which leaves the shape what it is.
double length(btScalar value) {
    return std::abs(double(value));
}

Reading readSphere(const btSphereShape& sphere) {
    return HullPart(Sphere{Vec3::Zero(), length(sphere.getRadius())});
}

Reading readCapsule(const btCapsuleShape& capsule) {
    const Vec3 end = double(capsule.getHalfHeight()) * Vec3::Unit(capsule.getUpAxis());
    const double radius = length(capsule.getRadius());
    if (!end.allFinite() || !std::isfinite(radius)) return HullError::notFinite;
    if (!(end.norm() > 0)) return HullPart(Sphere{Vec3::Zero(), radius});
    return HullPart(makeTaperedCapsule(-end, radius, end, radius));
}

Reading readCylinder(const btCylinderShape& cylinder) {
    const int axis = cylinder.getUpAxis();
    return HullPart(makeCylinder(Vec3::Zero(), Vec3::Unit(axis), length(cylinder.getRadius()),
                                 length(cylinder.getHalfExtentsWithMargin()[axis])));
}

Reading readCone(const btConeShape& cone) {
    const double height = length(cone.getHeight());
    Vec3 axis = Vec3::Unit(cone.getConeUpIndex());
    if (cone.getHeight() < 0) axis = -axis;
    return HullPart(makeCone(-height / 2 * axis, axis, length(cone.getRadius()), height));
}

/// Vertices round the unit sphere, moved outward so that the polyhedron has the volume of the sphere.
std::vector<Vec3> ballVertices(int levels) {
    const Sphere unit{Vec3::Zero(), 1};
    TriangleMesh mesh = tessellate(unit, levels);
    const double factor = std::cbrt(volumeMoments(unit).volume / volumeMoments(mesh).volume);
    for (Vec3& vertex : mesh.vertices)
        vertex *= factor;
    return mesh.vertices;
}

/// By how much a tessellated sphere falls short of the true one before it is moved outward.
double ballError(int levels) {
    const Sphere unit{Vec3::Zero(), 1};
    return 1 - volumeMoments(tessellate(unit, levels)).volume / volumeMoments(unit).volume;
}

/// Spheres scaled alike in all directions, if there are so few, and none within the other, that a formula
/// holds.
bool readAsSolid(const std::vector<Sphere>& spheres, Reading& reading) {
    if (spheres.size() == 1) reading = HullPart(spheres[0]);
    if (spheres.size() == 2) {
        const double distance = (spheres[0].centre - spheres[1].centre).norm();
        if (distance > std::abs(spheres[0].radius - spheres[1].radius))
            reading = HullPart(makeTaperedCapsule(spheres[0].centre, spheres[0].radius, spheres[1].centre,
                                                  spheres[1].radius));
        else
            reading = HullPart(spheres[0].radius > spheres[1].radius ? spheres[0] : spheres[1]);
    }
    return spheres.size() == 1 || spheres.size() == 2;
}

Reading readMultiSphere(const btMultiSphereShape& shape) {
    const Vec3 scaling = toEigen(shape.getLocalScaling());
    std::vector<Sphere> spheres;
    for (int i = 0; i < shape.getSphereCount(); ++i)
        spheres.push_back({toEigen(shape.getSpherePosition(i)).cwiseProduct(scaling),
                           length(shape.getSphereRadius(i)) * std::abs(scaling.x())});
    const auto isFinite = [](const Sphere& s) { return s.centre.allFinite() && std::isfinite(s.radius); };
    if (!std::all_of(spheres.begin(), spheres.end(), isFinite)) return HullError::notFinite;
    Reading reading;
    const bool uniform = scaling.cwiseAbs().isConstant(std::abs(scaling.x()), 0);
    if (uniform && readAsSolid(spheres, reading)) return reading;

    const std::vector<Vec3> ball = ballVertices(sphereLevels);
    std::vector<Vec3> points;
    for (int i = 0; i < shape.getSphereCount(); ++i)
        for (const Vec3& vertex : ball)
            points.push_back(spheres[std::size_t(i)].centre +
                             double(shape.getSphereRadius(i)) * scaling.cwiseProduct(vertex));
    reading = hullOf(points);
    reading.status.tessellationError = ballError(sphereLevels);
    return reading;
}

/// Points whose convex hull is that of the part.
std::vector<Vec3> outerPoints(const HullPart& part, double& tessellationError) {
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) return mesh->vertices;
    tessellationError = ballError(minkowskiLevels);
    if (const auto* solid = std::get_if<SolidOfRevolution>(&part))
        return tessellate(*solid, minkowskiSegments).vertices;
    const Sphere& sphere = std::get<Sphere>(part);
    std::vector<Vec3> points = ballVertices(minkowskiLevels);
    for (Vec3& point : points)
        point = sphere.centre + sphere.radius * point;
    return points;
}

/// Bullet's "sum" takes the second shape mirrored at its origin: A - B.
Reading readMinkowskiSum(const btMinkowskiSumShape& sum) {
    const Reading a = read(*sum.getShapeA()), b = read(*sum.getShapeB());
    if (a.failed()) return a;
    if (b.failed()) return b;
    if (a.parts.size() != 1 || b.parts.size() != 1)
        return refused("a Minkowski sum of compounds is not convex");
    double tessellationError = std::max(a.status.tessellationError, b.status.tessellationError);
    const auto pointsA = outerPoints(placed(a.parts[0], toPose(sum.getTransformA())), tessellationError);
    const auto pointsB = outerPoints(placed(b.parts[0], toPose(sum.GetTransformB())), tessellationError);
    std::vector<Vec3> points;
    for (const Vec3& pointA : pointsA)
        for (const Vec3& pointB : pointsB)
            points.push_back(pointA - pointB);
    Reading reading = hullOf(points);
    reading.status.tessellationError = tessellationError;
    return reading;
}

Reading readMesh(const btStridingMeshInterface& source, const Vec3& scaling) {
    TriangleMesh mesh;
    for (int part = 0; part < source.getNumSubParts(); ++part)
        readStridingMesh(source, part, scaling, mesh);
    return HullPart(std::move(mesh));
}

Reading readMesh(const btStridingMeshInterface& source) {
    return readMesh(source, toEigen(source.getScaling()));
}

Reading readScaledMesh(const btScaledBvhTriangleMeshShape& shape) {
    const btStridingMeshInterface& source = *shape.getChildShape()->getMeshInterface();
    return readMesh(source, toEigen(source.getScaling()).cwiseProduct(toEigen(shape.getLocalScaling())));
}

/// Appends the parts of a child; false if it has none, with the reason in `reading`.
bool addChild(Reading& reading, const btCollisionShape& child, const Pose& pose, double scale = 1) {
    Reading inner = read(child);
    if (inner.failed()) {
        reading = inner;
        return false;
    }
    for (const HullPart& part : inner.parts)
        reading.parts.push_back(placed(part, pose, scale));
    reading.status.tessellationError =
        std::max(reading.status.tessellationError, inner.status.tessellationError);
    return true;
}

Reading readCompound(const btCompoundShape& compound) {
    Reading reading;
    for (int i = 0; i < compound.getNumChildShapes(); ++i)
        if (!addChild(reading, *compound.getChildShape(i), toPose(compound.getChildTransform(i)))) break;
    return reading;
}

Reading readUniformScaling(const btUniformScalingShape& shape) {
    Reading reading;
    addChild(reading, *shape.getChildShape(), Pose{}, double(shape.getUniformScalingFactor()));
    return reading;
}

/// All GImpact shapes share one shape type.
Reading readGImpact(const btGImpactShapeInterface& shape) {
    switch (shape.getGImpactShapeType()) {
        case CONST_GIMPACT_TRIMESH_SHAPE: {
            const auto& mesh = static_cast<const btGImpactMeshShape&>(shape);
            if (mesh.getMeshPartCount() == 0) return HullError::noTriangles;
            return readMesh(*mesh.getMeshInterface(), toEigen(mesh.getMeshPart(0)->getLocalScaling()));
        }
        case CONST_GIMPACT_TRIMESH_SHAPE_PART: {
            // Its accessor to the user's arrays is not const, though it changes nothing.
            auto& part =
                const_cast<btGImpactMeshShapePart&>(static_cast<const btGImpactMeshShapePart&>(shape));
            const auto* manager = part.getTrimeshPrimitiveManager();
            TriangleMesh mesh;
            readStridingMesh(*manager->m_meshInterface, manager->m_part, toEigen(manager->m_scale), mesh);
            return HullPart(std::move(mesh));
        }
        case CONST_GIMPACT_COMPOUND_SHAPE: {
            auto& compound =
                const_cast<btGImpactCompoundShape&>(static_cast<const btGImpactCompoundShape&>(shape));
            Reading reading;
            for (int i = 0; i < compound.getNumChildShapes(); ++i) {
                const bool placedByTransform = compound.childrenHasTransform();
                const Pose pose = placedByTransform ? toPose(compound.getChildTransform(i)) : Pose{};
                if (!addChild(reading, *compound.getChildShape(i), pose)) break;
            }
            return reading;
        }
    }
    return refused("a GImpact shape of unknown kind");
}

Reading read(const btCollisionShape& shape) {
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE:
            return readBox(as<btBoxShape>(shape));
        case SPHERE_SHAPE_PROXYTYPE:
            return readSphere(as<btSphereShape>(shape));
        case CAPSULE_SHAPE_PROXYTYPE:
            return readCapsule(as<btCapsuleShape>(shape));
        case CYLINDER_SHAPE_PROXYTYPE:
            return readCylinder(as<btCylinderShape>(shape));
        case CONE_SHAPE_PROXYTYPE:
            return readCone(as<btConeShape>(shape));
        case MULTI_SPHERE_SHAPE_PROXYTYPE:
            return readMultiSphere(as<btMultiSphereShape>(shape));
        case CONVEX_HULL_SHAPE_PROXYTYPE:
            return readConvexHull(as<btConvexHullShape>(shape));
        case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
            return readPointCloud(as<btConvexPointCloudShape>(shape));
        case TRIANGLE_SHAPE_PROXYTYPE:
        case TETRAHEDRAL_SHAPE_PROXYTYPE:
            return readPolyhedron(as<btPolyhedralConvexShape>(shape));
        case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
            return readMesh(*as<btConvexTriangleMeshShape>(shape).getMeshInterface());
        case TRIANGLE_MESH_SHAPE_PROXYTYPE:
        case MULTIMATERIAL_TRIANGLE_MESH_PROXYTYPE:
            return readMesh(*as<btBvhTriangleMeshShape>(shape).getMeshInterface());
        case SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE:
            return readScaledMesh(as<btScaledBvhTriangleMeshShape>(shape));
        case GIMPACT_SHAPE_PROXYTYPE:
            return readGImpact(as<btGImpactShapeInterface>(shape));
        case UNIFORM_SCALING_SHAPE_PROXYTYPE:
            return readUniformScaling(as<btUniformScalingShape>(shape));
        case MINKOWSKI_DIFFERENCE_SHAPE_PROXYTYPE:
            return readMinkowskiSum(as<btMinkowskiSumShape>(shape));
        case COMPOUND_SHAPE_PROXYTYPE:
            return readCompound(as<btCompoundShape>(shape));
        case STATIC_PLANE_PROXYTYPE:
            return refused("a plane has no volume");
        case TERRAIN_SHAPE_PROXYTYPE:
            return refused("a heightfield is ground, not a floating body");
        case EMPTY_SHAPE_PROXYTYPE:
            return refused("an empty shape has no volume");
        case BOX_2D_SHAPE_PROXYTYPE:
        case CONVEX_2D_SHAPE_PROXYTYPE:
            return refused("a 2D shape has no volume");
        case SOFTBODY_SHAPE_PROXYTYPE:
            return refused("a soft body has no rigid hull");
        default:
            return refused("shapes of this type are not known to the library: give a hull in BodyDef");
    }
}

}  // namespace

HullResult hullFromShape(const btCollisionShape& shape) {
    Reading reading = read(shape);
    if (reading.failed()) return {nullptr, reading.status};
    HullResult result = makeHull(std::move(reading.parts));
    result.status.tessellationError = reading.status.tessellationError;
    return result;
}

}  // namespace bullet_buoyancy
