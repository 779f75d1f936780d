#include "scenes/free_spin.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/motion/inertia.h"
#include "scenes/float_scene.h"

namespace bullet_buoyancy::scenes {

namespace {

/// Of a body that Bullet turns by itself.
Vec3 angularMomentum(const btRigidBody& body) {
    Inertia inertia;
    inertia.principal = toEigen(body.getLocalInertia());
    return inertia.momentum(poseOf(body).orientation, toEigen(body.getAngularVelocity()));
}

}  // namespace

std::vector<SpinSample> spinFreely(const SpinDef& def, SpinOwner owner, const Stepping& stepping) {
    FloatScene scene;
    Pose pose;
    pose.position = -10 * def.size.norm() * scene.water().frame().upWorld();
    btRigidBody& box = scene.addBody(std::make_unique<btBoxShape>(toBullet(def.size / 2)),
                                     scene.water().density() * def.size.prod(), pose);
    box.setAngularVelocity(toBullet(def.spin));
    BodyDef body;
    body.linearDrag = 0;
    body.angularDamping = def.dampingRate;
    if (owner == SpinOwner::library)
        scene.buoyancy().addBody(box, body);
    else  // Bullet's damping d is a factor (1 - d) a second; neutral in the water, it needs no gravity
        box.setDamping(0, btScalar(1 - std::exp(-def.dampingRate)));
    if (owner == SpinOwner::bullet) box.setGravity({0, 0, 0});

    std::vector<SpinSample> samples{{0, angularMomentum(box)}};
    while (scene.time() < def.seconds) {
        scene.step(stepping.dt, stepping.substeps);
        samples.push_back({scene.time(), owner == SpinOwner::library
                                             ? toEigen(scene.report(box).angularMomentum)
                                             : angularMomentum(box)});
    }
    return samples;
}

SpinError spinError(const std::vector<SpinSample>& samples, double dampingRate) {
    const Vec3 start = samples.front().angularMomentum;
    SpinError error{0, 0};
    for (const SpinSample& sample : samples) {
        const double expected = start.norm() * std::exp(-dampingRate * sample.time);
        const Vec3& momentum = sample.angularMomentum;
        error.length = std::max(error.length, std::abs(momentum.norm() / expected - 1));
        error.angle = std::max(error.angle, std::atan2(start.cross(momentum).norm(), start.dot(momentum)));
    }
    return error;
}

}  // namespace bullet_buoyancy::scenes
