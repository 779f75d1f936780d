#include "scenes/floating_cube.h"

#include <algorithm>
#include <cmath>

#include "scenes/float_scene.h"

namespace bullet_buoyancy::scenes {

namespace {

double tiltOf(const btRigidBody& cube, const WaterField& water) {
    return std::acos(std::min(1.0, upInBody(cube, water).cwiseAbs().maxCoeff()));
}

/// One that is not known in closed form is meant where none that is known is near.
CubeOrientation nearest(const std::vector<CubeOrientation>& stable, double tilt) {
    constexpr double near = 0.1, unknown = near;  // radians
    const auto distance = [&](const CubeOrientation& orientation) {
        return orientation.tilt < 0 ? unknown : std::abs(orientation.tilt - tilt);
    };
    return *std::min_element(stable.begin(), stable.end(),
                             [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

}  // namespace

CubeResult dropCube(const CubeDef& def, const Stepping& stepping) {
    FloatScene scene;
    Pose pose;
    pose.position = def.dropHeight * def.size * scene.water().frame().upWorld();
    pose.orientation = Eigen::AngleAxisd(0.5, Vec3(0.2, 0.7, 0.4).normalized());
    BodyDef body;
    body.linearDrag = def.linearDrag;
    body.angularDamping = def.angularDamping;
    btRigidBody& cube = scene.addFloatingBox(Vec3::Constant(def.size), def.ratio, pose, body);
    CubeResult result;
    while (scene.time() < def.seconds) {
        scene.step(stepping.dt, stepping.substeps);
        result.samples.push_back({scene.time(), heightAboveWater(cube, scene.water()) / def.size,
                                  tiltOf(cube, scene.water()), scene.report(cube).totalEnergy()});
    }
    const double tilt = result.samples.back().tilt;
    result.reached = nearest(stableCubeOrientations(def.ratio), tilt);
    result.tiltDeviation = result.reached.tilt < 0 ? 0 : std::abs(tilt - result.reached.tilt);
    constexpr double restSpeed = 1e-4;  // m/s
    const BodyReport report = scene.report(cube);
    result.atRest = 2 * report.kineticEnergy * double(cube.getInvMass()) < restSpeed * restSpeed;
    result.submergedFraction = report.wetFraction;
    return result;
}

HeaveResult heaveSlab(double ratio, double amplitude, const Stepping& stepping) {
    constexpr double height = 1, seconds = 60;
    FloatScene scene;
    const double restHeight = (0.5 - ratio) * height;
    Pose pose;
    pose.position = (restHeight + amplitude) * scene.water().frame().upWorld();
    BodyDef frictionless;
    frictionless.linearDrag = frictionless.angularDamping = 0;
    btRigidBody& slab = scene.addFloatingBox({2, 2, height}, ratio, pose, frictionless);

    // Downward passages through the draft, each interpolated between two steps.
    double firstPassage = 0, lastPassage = 0, highest = -height, lowest = height;
    int periods = -1;
    double before = amplitude;
    while (scene.time() < seconds) {
        scene.step(stepping.dt, stepping.substeps);
        const double now = heightAboveWater(slab, scene.water()) - restHeight;
        if (before > 0 && now <= 0) {
            lastPassage = scene.time() - stepping.dt * now / (now - before);
            if (++periods == 0) firstPassage = lastPassage;
        }
        highest = std::max(highest, now);
        lowest = std::min(lowest, now);
        before = now;
    }
    return {(lastPassage - firstPassage) / periods, height / 2 - restHeight - (highest + lowest) / 2};
}

}  // namespace bullet_buoyancy::scenes
