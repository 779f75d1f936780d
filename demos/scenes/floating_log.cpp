#include "scenes/floating_log.h"

#include <algorithm>
#include <cmath>

#include "scenes/float_scene.h"

namespace bullet_buoyancy::scenes {

namespace {

constexpr double length = 8;          // in sides: long enough that it never stands up
constexpr double releaseTilt = 0.3;   // radians, from which both flat and 45 degrees are reached downhill
constexpr double limit = 600;         // s
constexpr double restEnergy = 1e-13;  // J per kg: a speed of 4.5e-7 m/s
constexpr double restTime = 2;        // s at rest, so that a turning point of the motion is not taken for it

/// Rotation about the log's long axis, the body's x.
double tiltOf(const btRigidBody& log, const WaterField& water) {
    const Vec3 up = upInBody(log, water);
    const double y = std::abs(up.y()), z = std::abs(up.z());
    return std::atan2(std::min(y, z), std::max(y, z));
}

}  // namespace

LogResult floatLog(double ratio, const Stepping& stepping) {
    FloatScene scene;
    Pose pose;
    pose.position = (0.5 - ratio) * scene.water().frame().upWorld();
    pose.orientation = Eigen::AngleAxisd(releaseTilt, Vec3::UnitX());
    BodyDef def;
    def.linearDrag = 3;
    def.angularDamping = 2;
    def.scaleByWetFraction = false;  // light logs would take minutes to settle
    btRigidBody& log = scene.addFloatingBox({length, 1, 1}, ratio, pose, def);

    const double mass = 1 / double(log.getInvMass());
    double restingSince = 0;
    while (scene.time() < limit && scene.time() - restingSince < restTime) {
        scene.step(stepping.dt, stepping.substeps);
        if (scene.report(log).kineticEnergy > restEnergy * mass) restingSince = scene.time();
    }
    return {ratio, tiltOf(log, scene.water()), heightAboveWater(log, scene.water()), restingSince};
}

double findLogThreshold(double low, double high, double tilt, const Stepping& stepping) {
    while (high - low > 0.001) {
        const double middle = (low + high) / 2;
        (floatLog(middle, stepping).tilt > tilt ? high : low) = middle;
    }
    return (low + high) / 2;
}

}  // namespace bullet_buoyancy::scenes
