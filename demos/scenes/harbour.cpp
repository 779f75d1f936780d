#include "scenes/harbour.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/solids.h"

namespace bullet_buoyancy::scenes {

namespace {

/// Of a run, in which bodies are to be at rest, s.
constexpr double lastSeconds = 1;

using Bodies = std::vector<btRigidBody*>;

SceneDef sceneFor(Floater floater) {
    SceneDef def;
    def.floater = floater;
    return def;
}

Pose at(const Vec3& position) {
    return {position, Eigen::Quaterniond::Identity()};
}

btRigidBody& addFloating(FloatScene& scene, Solid solid, const Vec3& size, double ratio, const Pose& pose) {
    const double mass = ratio * scene.water().density() * volumeOf(solid, size);
    btRigidBody& body = scene.addBody(makeShape(solid, size), mass, pose);
    scene.floatBody(body);
    return body;
}

double highestOf(const FloatScene& scene, const Bodies& bodies) {
    double highest = std::numeric_limits<double>::lowest();
    for (const btRigidBody* body : bodies)
        highest = std::max(highest, heightAboveWater(*body, scene.water()));
    return highest;
}

/// Runs for `seconds`; fills `highest` (rise above the starts), `speed` and `finite`.
HeldResult hold(FloatScene& scene, const Bodies& bodies, double seconds, const Stepping& stepping) {
    std::vector<double> starts;
    for (const btRigidBody* body : bodies)
        starts.push_back(heightAboveWater(*body, scene.water()));
    HeldResult result{0, 0, 0, true};
    const double end = scene.time() + seconds;
    while (scene.time() < end && result.finite) {
        const double speed = stepAndClock(scene, bodies, stepping);
        result.finite = std::isfinite(speed);
        if (scene.time() > end - lastSeconds) result.speed = std::max(result.speed, speed);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            result.highest =
                std::max(result.highest, heightAboveWater(*bodies[i], scene.water()) - starts[i]);
    }
    return result;
}

/// A chain along x about the origin, its links laid in zigzag so that it is slack by a little.
struct Chain {
    static constexpr int links = 30;
    static constexpr double pitch = 1, slack = 29.0 / 30;
    Bodies barrels;
    std::vector<btPoint2PointConstraint*> joints;
};

void join(FloatScene& scene, Chain& chain, std::unique_ptr<btPoint2PointConstraint> joint) {
    chain.joints.push_back(joint.get());
    scene.addJoint(std::move(joint));
}

Chain layChain(FloatScene& scene) {
    Chain chain;
    const btVector3 end(0, btScalar(Chain::pitch / 2), 0);  // barrels lie along their y
    const double turn = std::acos(Chain::slack);
    for (int i = 0; i < Chain::links; ++i) {
        const double angle = (i % 2 == 0 ? turn : -turn) - pi / 2;
        Pose pose = at({(i + 0.5) * Chain::slack * Chain::pitch, std::sin(turn) * Chain::pitch / 2, 0});
        pose.orientation = Eigen::AngleAxisd(angle, Vec3::UnitZ());
        btRigidBody& barrel = addFloating(scene, Solid::cylinder, {0.6, 0.9, 0}, 0.2, pose);
        if (i == 0)
            join(scene, chain, std::make_unique<btPoint2PointConstraint>(barrel, -end));
        else
            join(scene, chain,
                 std::make_unique<btPoint2PointConstraint>(*chain.barrels.back(), barrel, end, -end));
        chain.barrels.push_back(&barrel);
    }
    join(scene, chain, std::make_unique<btPoint2PointConstraint>(*chain.barrels.back(), end));
    return chain;
}

/// A point joint to the world has its second pivot in the world's frame.
double gap(btPoint2PointConstraint& joint) {
    const btVector3 a = joint.getRigidBodyA().getWorldTransform() * joint.getPivotInA();
    const bool toWorld = joint.getRigidBodyB().isStaticObject();
    const btVector3 b =
        toWorld ? joint.getPivotInB() : joint.getRigidBodyB().getWorldTransform() * joint.getPivotInB();
    return double((a - b).length());
}

}  // namespace

ChainResult chainBarrels(Floater floater, const Stepping& stepping) {
    constexpr double seconds = 60, pulledTaut = 1;
    FloatScene scene(sceneFor(floater));
    const Chain chain = layChain(scene);
    ChainResult result{0, 0, 0, true};
    while (scene.time() < seconds && result.finite) {
        const double speed = stepAndClock(scene, chain.barrels, stepping);
        result.finite = std::isfinite(speed);
        if (scene.time() > seconds - lastSeconds) result.speed = std::max(result.speed, speed);
        result.highest = std::max(result.highest, highestOf(scene, chain.barrels));
        if (scene.time() < pulledTaut) continue;
        for (btPoint2PointConstraint* joint : chain.joints)
            result.widestGap = std::max(result.widestGap, gap(*joint));
    }
    return result;
}

HeldResult wedgeCrate(Floater floater, const Stepping& stepping) {
    constexpr double wall = 1, tooClose = 0.005;
    FloatScene scene(sceneFor(floater));
    const double x = 0.5 + wall / 2 - tooClose / 2;
    scene.addStatic(makeShape(Solid::box, {wall, 10, 10}), at({x, 0, 0}));
    scene.addStatic(makeShape(Solid::box, {wall, 10, 10}), at({-x, 0, 0}));
    btRigidBody& crate = addFloating(scene, Solid::box, {1, 1, 1}, 0.2, at({0, 0, 0.3}));
    HeldResult result = hold(scene, {&crate}, 20, stepping);
    result.deepest = std::abs(poseOf(crate).position.x());
    return result;
}

HeldResult beach(double ratio, Floater floater, const Stepping& stepping) {
    constexpr double thickness = 4, size = 0.5;
    FloatScene scene(sceneFor(floater));
    const double slope = std::atan(0.25);  // rises along x
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(-slope, Vec3::UnitY()));
    const Vec3 normal = turn * Vec3::UnitZ();
    btRigidBody& sand =
        scene.addStatic(makeShape(Solid::box, {60, 60, thickness}), {-thickness / 2 * normal, turn});
    sand.setRollingFriction(btScalar(0.05));
    Bodies bodies;
    for (Solid solid : {Solid::box, Solid::sphere, Solid::cylinder}) {
        const Vec3 along(0, 2.0 * double(bodies.size()), 0);
        bodies.push_back(&addFloating(scene, solid, Vec3::Constant(size), ratio,
                                      {along + (size / 2 + 0.01) * normal, turn}));
        bodies.back()->setRollingFriction(btScalar(0.05));
    }
    HeldResult result = hold(scene, bodies, 180, stepping);
    for (const btRigidBody* body : bodies)
        result.deepest = std::max(result.deepest, size / 2 - poseOf(*body).position.dot(normal));
    return result;
}

DeckResult holdUnderDeck(Floater floater, const Stepping& stepping) {
    constexpr double size = 0.3, ratio = 0.03, depth = 1, thickness = 0.5, settlingLimit = 2000;
    FloatScene scene(sceneFor(floater));
    btRigidBody& deck =
        scene.addStatic(makeShape(Solid::box, {10, 10, thickness}), at({0, 0, -depth + thickness / 2}));
    Bodies boxes;
    for (int i = 0; i < 4; ++i)
        boxes.push_back(&addFloating(scene, Solid::box, Vec3::Constant(size), ratio,
                                     at({0.5 * i, 0, -depth - size / 2})));
    DeckResult result{hold(scene, boxes, 10, stepping), 0, true, 0};
    result.held.deepest = std::max(0.0, highestOf(scene, boxes) + depth + size / 2);
    scene.world().removeRigidBody(&deck);

    const double allowed = (depth + size / 2) * (1 / ratio - 1);
    for (double end = scene.time() + 60; scene.time() < end && result.held.finite;) {
        result.held.finite = std::isfinite(stepAndClock(scene, boxes, stepping));
        result.rise = std::max(result.rise, highestOf(scene, boxes) / allowed);
    }
    for (btRigidBody* box : boxes) {
        const Rest rest = awaitRest(scene, *box, {1e-3, 5, settlingLimit}, StepLengths(stepping));
        result.settled = result.settled && rest.reached;
        result.wetError = std::max(result.wetError, std::abs(rest.wetFraction / ratio - 1));
    }
    return result;
}

}  // namespace bullet_buoyancy::scenes
