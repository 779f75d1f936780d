#include "scenes/dropped_body.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/known_answers.h"

namespace bullet_buoyancy::scenes {

namespace {

double largestLength(const DropDef& def) {
    return def.size.maxCoeff();
}

}  // namespace

double positionRounding(const DropDef& def) {
    return bulletRounding * std::max(largestLength(def), def.scene.frame.originWorld().norm());
}

namespace {

btRigidBody& release(FloatScene& scene, const DropDef& def, const BodyDef& drag) {
    const Vec3 up = scene.water().frame().upWorld();
    const Pose pose{scene.water().frame().originWorld() + def.height * up,
                    Eigen::Quaterniond(scene.water().frame().worldFromFrame()) * def.orientation};
    const double mass = def.ratio * scene.water().density() * volumeOf(def.solid, def.size);
    btRigidBody& body = scene.addBody(makeShape(def.solid, def.size), mass, pose);
    body.setLinearVelocity(toBullet(-def.downwardSpeed * up));
    scene.floatBody(body, drag);
    return body;
}

BodyDef frictionless(const btCollisionShape& shape) {
    BodyDef def;
    def.hull = hullFromShape(shape).hull;
    def.linearDrag = def.angularDamping = 0;
    return def;
}

double smallerShare(double ratio) {
    return std::min(ratio, std::abs(1 - ratio));
}

/// At which a body swings by about all of its draft or freeboard, or creeps there against drag, m/s.
double swingSpeed(const DropDef& def, const BodyDef& drag) {
    const double share = smallerShare(def.ratio), gravity = def.scene.gravity;
    const double swing = std::sqrt(gravity * share * largestLength(def));
    return drag.linearDrag > 0 ? std::min(swing, share / def.ratio * gravity / drag.linearDrag) : swing;
}

/// The lightest bodies, which water hardly slows, may go on hopping by 1e-4 of their least length.
double hopSpeed(const DropDef& def) {
    constexpr double lightest = 0.01, hop = 1e-4;
    return def.ratio < lightest ? std::sqrt(2 * def.scene.gravity * hop * def.size.minCoeff()) : 0;
}

/// A body that is to move by less than the rounding in a step stands still, at any velocity up to this, m/s.
double slowestSpeed(const DropDef& def) {
    return positionRounding(def) / def.stepping.dt;
}

/// Bullet's rounding of the pose keeps a body moving, by what the water then does to it in a step, as a
/// random walk over the time in which damping forgets, m/s. Where it is light, the turn counts most: with all
/// that goes into one, some fifteen times the rounding of a number. The library keeps a pose of its own.
double roundingSpeed(const DropDef& def, const BodyDef& drag) {
    if (def.scene.floater == Floater::library) return 0;
    constexpr double turns = 20;
    const double wet = drag.scaleByWetFraction ? std::min(1.0, def.ratio) : 1;
    const double forgotten = std::min(1.0, drag.angularDamping * wet * def.stepping.dt);
    const double kick = turns * bulletRounding / def.ratio * def.scene.gravity * def.stepping.dt;
    return kick / std::sqrt(forgotten) + slowestSpeed(def);
}

}  // namespace

Eigen::Quaterniond askew() {
    return Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3(0.2, 0.7, 0.4).normalized()));
}

FallResult fallUndamped(const DropDef& def, double seconds) {
    FloatScene scene(def.scene);
    const BodyDef drag = frictionless(*makeShape(def.solid, def.size));
    btRigidBody& body = release(scene, def, drag);
    const double mass = 1 / double(body.getInvMass());
    const double start = energyAtRelease(scene, body, *drag.hull);
    const double allowed = start / (mass * def.scene.gravity);
    const double speed = std::sqrt(2 * start / mass) + def.scene.gravity * def.stepping.dt;
    constexpr double flownOff = 1e3;
    const Flight flight =
        observeFlight(scene, body, seconds, flownOff * allowed, StepLengths(def.stepping, def.shortestStep));
    return {flight.highest / allowed, (flight.mostEnergy - start) / start,
            flight.mostMotion / (mass * speed * speed / 2), flight.finite};
}

double motionShown(const DropDef& def) {
    if (def.height >= 0) return 1;
    const double acceleration = (1 / def.ratio - 1) * def.scene.gravity;
    const double fastest = std::sqrt(2 * acceleration * -def.height);
    return std::pow(1 + acceleration * def.stepping.dt / (2 * fastest), 2);
}

SettleResult settle(const DropDef& def, double limitSeconds, const BodyDef& drag) {
    FloatScene scene(def.scene);
    btRigidBody& body = release(scene, def, drag);
    const double share = smallerShare(def.ratio);
    RestDef rest{};
    rest.speed = std::max(3e-4 * swingSpeed(def, drag), hopSpeed(def)) + roundingSpeed(def, drag);
    rest.maxSteps = 100000000;
    rest.hold = std::max(5.0, 4 * pi * std::sqrt(largestLength(def) / def.scene.gravity));
    rest.limit = limitSeconds;
    const Rest reached = awaitRest(scene, body, rest, StepLengths(def.stepping, def.shortestStep));
    return {reached.reached, reached.finite, reached.after, std::abs(reached.wetFraction - def.ratio) / share,
            upInBody(body, scene.water())};
}

double tiltOfFace(const Vec3& upInCube) {
    return std::acos(std::min(1.0, upInCube.cwiseAbs().maxCoeff()));
}

double cubeTiltError(double ratio, const Vec3& upInCube) {
    const double tilt = tiltOfFace(upInCube);
    double nearest = pi;
    for (const CubeOrientation& stable : stableCubeOrientations(ratio))
        nearest = std::min(nearest, stable.tilt < 0 ? 0 : std::abs(tilt - stable.tilt));
    return nearest;
}

double wetErrorLimit(const DropDef& def, const BodyDef& drag) {
    const double rounding = positionRounding(def);
    const double share = smallerShare(def.ratio);
    constexpr double unresolved = 1e-5;  // of the length: what an implicit step leaves of a tiny draft
    return std::max(1e-3, unresolved / share) + 2 * rounding / (share * largestLength(def)) +
           roundingSpeed(def, drag) * drag.linearDrag * def.ratio / (share * def.scene.gravity);
}

double terminalVelocityError(const DropDef& def, double linearDrag) {
    FloatScene scene(def.scene);
    BodyDef drag;
    drag.linearDrag = linearDrag;
    btRigidBody& body = release(scene, def, drag);
    scene.run(std::max(30 / linearDrag, 20 * def.stepping.dt), def.stepping.dt, def.stepping.substeps);
    const double expected = (1 / def.ratio - 1) * def.scene.gravity / linearDrag;
    const double reached = toEigen(scene.report(body).velocity).dot(scene.water().frame().upWorld());
    return std::abs(reached - expected) / std::abs(expected);
}

}  // namespace bullet_buoyancy::scenes
