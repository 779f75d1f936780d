#include "scenes/observe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"

namespace bullet_buoyancy::scenes {

namespace {

/// Of a body that got from one pose to another in `dt` (s), steadily.
double kineticEnergyBetween(const btRigidBody& body, const Pose& before, const Pose& after, double dt) {
    const Eigen::AngleAxisd turn(before.orientation.conjugate() * after.orientation);
    const Vec3 spinInBody = turn.axis() * (turn.angle() / dt),
               velocity = (after.position - before.position) / dt;
    return velocity.squaredNorm() / double(body.getInvMass()) / 2 +
           toEigen(body.getLocalInertia()).cwiseProduct(spinInBody).dot(spinInBody) / 2;
}

double speedOf(const FloatScene& scene, const btRigidBody& body) {
    return std::sqrt(2 * scene.report(body).kineticEnergy * double(body.getInvMass()));
}

}  // namespace

bool isFinite(const FloatScene& scene, const btRigidBody& body) {
    Vec3 sum = toEigen(body.getWorldTransform().getOrigin()) + toEigen(body.getLinearVelocity()) +
               toEigen(body.getAngularVelocity());
    for (int row = 0; row < 3; ++row)
        sum += toEigen(body.getWorldTransform().getBasis()[row]);
    return sum.allFinite() && std::isfinite(scene.report(body).totalEnergy());
}

double energyAtRelease(const FloatScene& scene, const btRigidBody& body, const Hull& hull) {
    const Pose pose = poseOf(body);
    const double gravity = double(body.getGravity().length()), mass = 1 / double(body.getInvMass());
    const Vec3 spin = pose.orientation.conjugate() * toEigen(body.getAngularVelocity());
    const Vec3 momentum = toEigen(body.getLocalInertia()).cwiseProduct(spin);
    return mass * gravity * heightAboveWater(body, scene.water()) +
           mass * toEigen(body.getLinearVelocity()).squaredNorm() / 2 + momentum.dot(spin) / 2 +
           evaluateExact(hull, pose, scene.water(), {gravity}).potentialEnergy;
}

Flight observeFlight(FloatScene& scene, const btRigidBody& body, double seconds, double ceiling,
                     StepLengths steps) {
    constexpr double lowest = std::numeric_limits<double>::lowest();
    Flight flight{lowest, lowest, 0, true};
    const double end = scene.time() + seconds;
    while (scene.time() < end && flight.finite && flight.highest <= ceiling) {
        const Pose before = poseOf(body);
        const double dt = steps.step(scene);
        flight.finite = isFinite(scene, body);
        if (!flight.finite) break;
        flight.highest = std::max(flight.highest, heightAboveWater(body, scene.water()));
        flight.mostMotion = std::max(flight.mostMotion, kineticEnergyBetween(body, before, poseOf(body), dt));
        flight.mostEnergy = std::max(flight.mostEnergy, scene.report(body).totalEnergy());
    }
    return flight;
}

Rest awaitRest(FloatScene& scene, const btRigidBody& body, const RestDef& def, StepLengths steps) {
    Rest rest{false, true, 0, 0};
    const double start = scene.time();
    double restingSince = start, wetSum = 0;
    long restingSteps = 0;
    for (long i = 0; i < def.maxSteps && scene.time() - start < def.limit && !rest.reached; ++i) {
        steps.step(scene);
        rest.finite = isFinite(scene, body);
        if (!rest.finite) break;
        if (speedOf(scene, body) > def.speed) {
            restingSince = scene.time();
            restingSteps = 0;
            wetSum = 0;
        } else {
            ++restingSteps;
            wetSum += scene.report(body).wetFraction;
        }
        rest.reached = scene.time() - restingSince >= def.hold;
    }
    rest.after = restingSince - start;
    rest.wetFraction = restingSteps > 0 ? wetSum / double(restingSteps) : scene.report(body).wetFraction;
    return rest;
}

double stepAndClock(FloatScene& scene, const std::vector<btRigidBody*>& bodies, const Stepping& stepping) {
    std::vector<Pose> before;
    for (const btRigidBody* body : bodies)
        before.push_back(poseOf(*body));
    scene.step(stepping.dt, stepping.substeps);
    double farthest = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!isFinite(scene, *bodies[i])) return std::numeric_limits<double>::infinity();
        const Pose now = poseOf(*bodies[i]);
        btVector3 centre;
        btScalar radius = 0;
        bodies[i]->getCollisionShape()->getBoundingSphere(centre, radius);
        farthest =
            std::max(farthest, (now.position - before[i].position).norm() +
                                   double(radius) * now.orientation.angularDistance(before[i].orientation));
    }
    return farthest / stepping.dt;
}

}  // namespace bullet_buoyancy::scenes
