#include "scenes/tumbling.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/motion/inertia.h"
#include "scenes/rigid_rotation.h"

namespace bullet_buoyancy::scenes {

namespace {

/// As the library reports it, or as Bullet's spin makes it. What the poses show of a spin is its mean over a
/// step, not that of a moment; the orientation is held to a reference of its own.
Vec3 momentumOf(const FloatScene& scene, const btRigidBody& box, const Vec3& inertia, Floater floater) {
    if (floater == Floater::library) return toEigen(scene.report(box).angularMomentum);
    Inertia ofBox;
    ofBox.principal = inertia;
    return ofBox.momentum(poseOf(box).orientation, toEigen(box.getAngularVelocity()));
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
    int steps = 0;
    while (scene.time() < def.seconds && error.finite) {
        scene.step(def.stepping.dt, def.stepping.substeps);
        reference = rotateFreely(reference, inertia, def.stepping.dt, referenceSteps);
        error.finite = isFinite(scene, box);
        const Vec3 now = momentumOf(scene, box, inertia, def.floater);
        error.energy = std::max(error.energy, std::abs(scene.report(box).kineticEnergy / energy - 1));
        error.momentum = std::max(error.momentum, std::abs(now.norm() / momentum.norm() - 1));
        error.direction = std::max(error.direction, angleBetween(now, momentum));
        if (++steps == 1) continue;  // Bullet alone took the first one
        const double angle = poseOf(box).orientation.angularDistance(reference.orientation);
        error.orientation = std::max(error.orientation, angle);
    }
    return error;
}

}  // namespace bullet_buoyancy::scenes
