#include "scenes/surroundings.h"

#include <algorithm>
#include <cmath>

#include "scenes/dropped_body.h"

namespace bullet_buoyancy::scenes {

namespace {

std::vector<double> heightsOf(const SceneDef& def, double seconds, const Stepping& stepping) {
    FloatScene scene(def);
    const Eigen::Quaterniond frame(def.frame.worldFromFrame());
    btRigidBody& cube = scene.addFloatingBox({1, 1, 1}, 0.5, {1.5 * def.frame.upWorld(), frame * askew()});
    std::vector<double> heights;
    while (scene.time() < seconds) {
        scene.step(stepping.dt, stepping.substeps);
        heights.push_back(heightAboveWater(cube, scene.water()));
    }
    return heights;
}

std::vector<double> heaves(double seconds, const Stepping& stepping, Floater floater) {
    SceneDef def;
    def.floater = floater;
    FloatScene scene(def);
    BodyDef frictionless;
    frictionless.linearDrag = frictionless.angularDamping = 0;
    btRigidBody& slab =
        scene.addFloatingBox({2, 2, 1}, 0.5, {Vec3(0, 0, 0.1), Eigen::Quaterniond::Identity()}, frictionless);
    std::vector<double> heights;
    while (scene.time() < seconds) {
        scene.step(stepping.dt, stepping.substeps);
        heights.push_back(heightAboveWater(slab, scene.water()));
    }
    return heights;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace

double differenceOfUps(const Vec3& upWorld, double seconds, Floater floater, const Stepping& stepping) {
    SceneDef usual, turned;
    usual.floater = turned.floater = floater;
    turned.frame = WaterFrame::fromUp(Vec3::Zero(), upWorld);
    return largestDifference(heightsOf(usual, seconds, stepping), heightsOf(turned, seconds, stepping));
}

double driftWithoutGravity(Floater floater, const Stepping& stepping) {
    SceneDef def;
    def.gravity = 0;
    def.floater = floater;
    FloatScene scene(def);
    double drift = 0;
    std::vector<std::pair<btRigidBody*, Pose>> cubes;
    for (double height : {-0.2, -5.0, 5.0}) {
        const Pose pose{Vec3(4 * height, 0, height), askew()};
        cubes.emplace_back(&scene.addFloatingBox({1, 1, 1}, 0.5, pose), pose);
    }
    scene.run(5, stepping.dt, stepping.substeps);
    for (const auto& [cube, start] : cubes)
        drift = std::max(drift, (poseOf(*cube).position - start.position).norm());
    return drift;
}

double differenceOfSubsteps(double dt, Floater floater) {
    constexpr double seconds = 5;
    return largestDifference(heaves(seconds, {dt, 1}, floater), heaves(seconds, {dt, 8}, floater));
}

}  // namespace bullet_buoyancy::scenes
