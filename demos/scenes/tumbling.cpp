#include "scenes/tumbling.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/rigid_rotation.h"

namespace bullet_buoyancy::scenes {

namespace {

/// L in the middle of a step, from the poses alone: nothing that a stepper says of itself.
Vec3 momentumBetween(const Eigen::Quaterniond& before, const Eigen::Quaterniond& after, const Vec3& inertia,
                     double dt) {
    const Eigen::AngleAxisd turn(before.conjugate() * after);
    const Vec3 spinInBody = turn.axis() * (turn.angle() / dt);
    return before.slerp(0.5, after) * inertia.cwiseProduct(spinInBody);
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

TumbleError tumble(const TumbleDef& def) {
    constexpr int referenceSteps = 200;  // in one of ours: an error of some 1e-12
    SceneDef sceneDef;
    sceneDef.gravity = 0;
    sceneDef.floater = def.floater;
    FloatScene scene(sceneDef);
    const Pose start{Vec3(0, 0, 10 * def.halfExtents.maxCoeff()), Eigen::Quaterniond::Identity()};
    btRigidBody& box = scene.addBody(std::make_unique<btBoxShape>(toBullet(def.halfExtents)), 10, start);
    box.setAngularVelocity(toBullet(def.spin));
    scene.floatBody(box);

    const Vec3 inertia = toEigen(box.getLocalInertia());
    const Vec3 momentum = inertia.cwiseProduct(def.spin);
    const double energy = momentum.dot(def.spin) / 2;
    FreeRotation reference{Eigen::Quaterniond::Identity(), def.spin};
    TumbleError error{0, 0, 0, 0, true};
    while (scene.time() < def.seconds && error.finite) {
        const Eigen::Quaterniond before = poseOf(box).orientation;
        scene.step(def.stepping.dt, def.stepping.substeps);
        reference = rotateFreely(reference, inertia, def.stepping.dt, referenceSteps);
        error.finite = isFinite(scene, box);
        const Eigen::Quaterniond after = poseOf(box).orientation;
        const Vec3 now = momentumBetween(before, after, inertia, def.stepping.dt);
        error.energy = std::max(error.energy, std::abs(scene.report(box).kineticEnergy / energy - 1));
        error.momentum = std::max(error.momentum, std::abs(now.norm() / momentum.norm() - 1));
        error.direction = std::max(error.direction, angleBetween(now, momentum));
        error.orientation = std::max(error.orientation, after.angularDistance(reference.orientation));
    }
    return error;
}

}  // namespace bullet_buoyancy::scenes
