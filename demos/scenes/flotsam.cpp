#include "scenes/flotsam.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "scenes/boat.h"
#include "scenes/solids.h"
#include "scenes/wigley_hull.h"

namespace bullet_buoyancy::scenes {

namespace {

using Shapes = std::vector<std::unique_ptr<btCollisionShape>>;

/// A piece before it has a body.
struct Design {
    Shapes shapes;
    double ratio;
    std::shared_ptr<const Hull> hull = nullptr;  // null: as the shape
    Vec3 inertia = Vec3::Zero();                 // kg m^2; zero: as the shape
    bool upright = false;                        // let go as it floats, its z up
};

Shapes one(std::unique_ptr<btCollisionShape> shape) {
    Shapes shapes;
    shapes.push_back(std::move(shape));
    return shapes;
}

std::unique_ptr<btConvexHullShape> convexHull(const std::vector<Vec3>& points, const Vec3& origin) {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const Vec3& point : points)
        shape->addPoint(toBullet(point - origin), false);
    shape->recalcLocalAabb();
    return shape;
}

/// About its centre of mass.
Shapes makeLump(RandomNumbers& random) {
    const double x = random.uniform(0.5, 0.9), y = random.uniform(0.4, 0.7), z = random.uniform(0.3, 0.5);
    std::vector<Vec3> corners;
    for (int i = 0; i < 24; ++i)
        corners.push_back(Vec3(x, y, z).cwiseProduct(random.orientation() * Vec3::UnitX()));
    const HullResult askew = hullFromShape(*convexHull(corners, Vec3::Zero()));
    return one(convexHull(corners, askew.hull->moments.centroid()));
}

/// A deck on two barrels, about the centre of mass of them all.
Shapes makeRaft() {
    constexpr double radius = 0.3, length = 2.2, deck = 0.12, gap = 0.001;
    const double barrels = 2 * pi * radius * radius * length, planks = length * length * deck;
    const double above = radius + deck / 2 + gap, middle = planks * above / (planks + barrels);
    Shapes shapes = one(std::make_unique<btCompoundShape>());
    auto& compound = static_cast<btCompoundShape&>(*shapes.front());
    const auto addPart = [&](std::unique_ptr<btCollisionShape> part, const Vec3& place) {
        compound.addChildShape(toTransform({place, Eigen::Quaterniond::Identity()}), part.get());
        shapes.push_back(std::move(part));
    };
    addPart(makeShape(Solid::box, {length, length, deck}), {0, 0, above - middle});
    for (double side : {-1, 1})
        addPart(std::make_unique<btCylinderShapeX>(toBullet({length / 2, radius, radius})),
                {0, side * 0.7, -middle});
    return shapes;
}

/// It collides as the convex hull of what it displaces.
Design makeBoatDesign(double waterDensity) {
    WigleyDef wigley;
    wigley.length = 5.5;
    wigley.beam = 1.7;
    wigley.draft = 0.5;
    wigley.freeboard = 0.5;
    const TriangleMesh mesh = wigleyMesh(wigley);
    LadingDef lading;
    lading.waterDensity = waterDensity;
    lading.displacement = displacementBelowOrigin(mesh);
    const Boat boat = makeBoat(mesh, lading);
    return {one(convexHull(boat.hull->mesh.vertices, Vec3::Zero())),
            boat.displacement / boat.hull->moments.volume, boat.hull, boat.inertia, true};
}

Design design(Flotsam kind, RandomNumbers& random, double waterDensity) {
    const double size = random.uniform(0.75, 1.25), ratio = random.uniform(0.2, 0.6);
    switch (kind) {
        case Flotsam::crate:
            return {one(makeShape(Solid::box, size * Vec3(1.1, 0.9, random.uniform(0.6, 0.9)))), ratio};
        case Flotsam::barrel:
            return {one(makeShape(Solid::cylinder, size * Vec3(0.65, 1, 0))), ratio};
        case Flotsam::buoy:
            return {one(makeShape(Solid::sphere, size * Vec3(0.8, 0, 0))), ratio / 2};
        case Flotsam::fender:
            return {one(makeShape(Solid::capsule, size * Vec3(0.35, 0.8, 0))), ratio / 2};
        case Flotsam::spar:
            return {one(makeShape(Solid::cylinder, Vec3(0.22, 4 * size, 0))), 0.5 + ratio / 2};
        case Flotsam::plank:
            return {one(makeShape(Solid::box, Vec3(2.6 * size, 0.35, 0.1))), 0.4 + ratio / 2};
        case Flotsam::lump:
            return {makeLump(random), ratio};
        case Flotsam::raft:
            return {makeRaft(), ratio / 2, nullptr, Vec3::Zero(), true};
        case Flotsam::boat:
            break;
    }
    return makeBoatDesign(waterDensity);
}

/// A raft is rarer than the rest.
Flotsam drawKind(RandomNumbers& random) {
    const int kind = random.index(15);
    return kind == 14 ? Flotsam::raft : Flotsam(kind % int(Flotsam::raft));
}

/// Of the pieces above still water at first, m.
constexpr double lowest = 0.5;

/// Those that are let go upright come first, and so lowest.
std::vector<Flotsam> drawKinds(const FlotsamDef& def, RandomNumbers& random) {
    std::vector<Flotsam> kinds;
    kinds.push_back(Flotsam::boat);
    while (kinds.size() < std::size_t(def.bodies))
        kinds.push_back(drawKind(random));
    std::stable_partition(kinds.begin(), kinds.end(),
                          [](Flotsam kind) { return kind == Flotsam::boat || kind == Flotsam::raft; });
    return kinds;
}

FlotsamPiece build(Flotsam kind, Design design, double waterDensity) {
    btCollisionShape& shape = *design.shapes.front();
    const auto hull = design.hull ? design.hull : hullFromShape(shape).hull;
    assert(hull);
    const auto mass = btScalar(design.ratio * waterDensity * hull->moments.volume);
    btVector3 inertia = toBullet(design.inertia);
    if (design.inertia.isZero()) shape.calculateLocalInertia(mass, inertia);
    auto body = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &shape, inertia));
    return {kind, hull, design.ratio, std::move(design.shapes), std::move(body)};
}

}  // namespace

const char* nameOf(Flotsam kind) {
    constexpr const char* names[flotsamKinds] = {"crate", "barrel", "buoy", "fender", "spar",
                                                 "plank", "lump",   "raft", "boat"};
    return names[int(kind)];
}

FlotsamScene::FlotsamScene(const FlotsamDef& def, const WaterField& water)
    : m_water(water), m_buoyancy(water, def.buoyancy) {
    m_world.setGravity(toBullet(-standardGravity * water.frame().upWorld()));
    m_world.addAction(&m_buoyancy);
    RandomNumbers random(def.seed);
    const double reach = std::sqrt(def.bodies * def.area / pi);
    const Eigen::Quaterniond level(water.frame().worldFromFrame());
    for (Flotsam kind : drawKinds(def, random)) {
        Design drawn = design(kind, random, water.density());
        const bool upright = drawn.upright;
        FlotsamPiece piece = build(kind, std::move(drawn), water.density());
        const Eigen::Quaterniond turn =
            upright ? Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(-pi, pi), Vec3::UnitZ()))
                    : random.orientation();
        const double radius = piece.hull->bounds.radius, height = lowest + (upright ? 0 : radius);
        const Vec3 place = freePlace(random, radius, m_pieces.empty() ? 0 : reach, height);
        piece.body->setWorldTransform(
            toTransform({water.frame().originWorld() + level * place, level * turn}));
        add(std::move(piece));
    }
}

FlotsamScene::~FlotsamScene() {
    for (const FlotsamPiece& piece : m_pieces)
        m_world.removeRigidBody(piece.body.get());
    m_world.removeAction(&m_buoyancy);
}

/// As low as no other piece is in the way, in the water's frame.
Vec3 FlotsamScene::freePlace(RandomNumbers& random, double radius, double reach, double height) const {
    const double angle = random.uniform(-pi, pi), distance = reach * std::sqrt(random.uniform(0, 1));
    Vec3 place(distance * std::cos(angle), distance * std::sin(angle), height);
    for (bool isFree = false; !isFree;) {
        isFree = true;
        for (const FlotsamPiece& piece : m_pieces) {
            const Vec3 other =
                m_water.frame().pointFromWorld(toEigen(piece.body->getWorldTransform().getOrigin()));
            const double clear = radius + piece.hull->bounds.radius,
                         beside = (place - other).head<2>().norm();
            if (beside >= clear ||
                std::abs(place.z() - other.z()) >= std::sqrt(clear * clear - beside * beside))
                continue;
            place.z() = other.z() + std::sqrt(clear * clear - beside * beside) + 1e-3 * clear;
            isFree = false;
        }
    }
    return place;
}

void FlotsamScene::add(FlotsamPiece piece) {
    m_world.addRigidBody(piece.body.get());
    BodyDef def;
    def.hull = piece.hull;
    const BodyStatus status = m_buoyancy.addBody(*piece.body, def);
    assert(status.ok());
    static_cast<void>(status);
    m_pieces.push_back(std::move(piece));
}

void FlotsamScene::step(double dt) {
    m_world.stepSimulation(btScalar(dt), 0);
}

}  // namespace bullet_buoyancy::scenes
