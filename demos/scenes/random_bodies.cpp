#include "scenes/random_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/solids.h"

namespace bullet_buoyancy::scenes {

namespace {

struct RandomBody {
    Solid solid;
    Vec3 size;
    double ratio;
    Pose pose;
    Vec3 velocity, spin;
    double dt;
};

/// The order of the draws is part of the sequence.
RandomBody drawBody(RandomNumbers& random) {
    constexpr double fastestTurn = 0.5;  // of a step, radians: Bullet turns a body by no more than pi / 4
    RandomBody body{};
    body.solid = Solid(random.index(4));
    for (double& length : body.size)
        length = random.logUniform(0.02, 10);
    body.ratio = random.logUniform(1e-4, 2);
    body.dt = random.logUniform(1.0 / 240, 0.1);
    const double reach = body.size.maxCoeff();
    body.pose.position = {0, 0, random.uniform(-2, 2) * reach};
    body.pose.orientation = random.orientation();
    body.velocity = random.inCube(random.logUniform(0.01, 10));
    body.spin = random.inCube(std::min(random.logUniform(0.01, 10), fastestTurn / body.dt / std::sqrt(3.0)));
    return body;
}

/// Largest gain of energy over its scale; infinite if the body is not finite.
double worstGain(const RandomBody& drawn, int steps, Floater floater) {
    SceneDef sceneDef;
    sceneDef.floater = floater;
    FloatScene scene(sceneDef);
    const double mass = drawn.ratio * scene.water().density() * volumeOf(drawn.solid, drawn.size);
    btRigidBody& body = scene.addBody(makeShape(drawn.solid, drawn.size), mass, drawn.pose);
    body.setLinearVelocity(toBullet(drawn.velocity));
    body.setAngularVelocity(toBullet(drawn.spin));
    BodyDef frictionless;
    frictionless.hull = hullFromShape(*body.getCollisionShape()).hull;
    frictionless.linearDrag = frictionless.angularDamping = 0;
    scene.floatBody(body, frictionless);

    const double start = energyAtRelease(scene, body, *frictionless.hull);
    const double height = drawn.pose.position.z(), weight = mass * standardGravity;
    const double scale = start - weight * height + weight * (std::abs(height) + drawn.size.maxCoeff());
    double worst = std::numeric_limits<double>::lowest();
    for (int i = 0; i < steps; ++i) {
        scene.step(drawn.dt);
        if (!isFinite(scene, body)) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, (scene.report(body).totalEnergy() - start) / scale);
    }
    return worst;
}

}  // namespace

RandomBodiesResult dropRandomBodies(const RandomBodiesDef& def) {
    constexpr double gain = 1e-3;
    RandomNumbers random(def.seed);
    RandomBodiesResult result{std::numeric_limits<double>::lowest(), 0, 0, 0};
    for (int i = 0; i < def.bodies; ++i) {
        const double worst = worstGain(drawBody(random), def.stepsEach, def.floater);
        result.gainers += worst > gain;
        result.notFinite += !std::isfinite(worst);
        if (worst <= result.worstGain) continue;
        result.worstGain = worst;
        result.worstBody = std::uint64_t(i);
    }
    return result;
}

}  // namespace bullet_buoyancy::scenes
