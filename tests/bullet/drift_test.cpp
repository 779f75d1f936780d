#include <gtest/gtest.h>

#include <cmath>

#include "scenes/float_scene.h"
#include "scenes/known_answers.h"

namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;
using scenes::heightAboveWater;
using scenes::poseOf;

constexpr double dt = 1.0 / 64;  // a binary fraction, so that Bullet's clock of substeps is exact
constexpr double hour = 3600;

struct Rest {
    double ratio;
    Eigen::Quaterniond orientation;
    const char* name;
};

std::vector<Rest> restingCubes() {
    const Eigen::Quaterniond cornerUp =
        Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1).normalized(), Vec3::UnitZ());
    return {{0.1, Eigen::Quaterniond::Identity(), "face up"}, {0.5, cornerUp, "corner up"}};
}

struct AfterAnHour {
    Pose pose;
    double energyGain;  ///< J per kg
};

AfterAnHour restForAnHour(const Rest& rest, const BodyDef& def, int substepsACall) {
    FloatScene scene;
    Pose start;
    start.orientation = rest.orientation;
    if (rest.ratio == 0.1) start.position.z() = 0.4;
    btRigidBody& cube = scene.addFloatingBox({1, 1, 1}, rest.ratio, start, def);
    scene.step(dt);
    const double energy = scene.report(cube).totalEnergy();
    scene.run(hour, substepsACall * dt, substepsACall);
    return {poseOf(cube), (scene.report(cube).totalEnergy() - energy) * double(cube.getInvMass())};
}

/// Rounding of the pose in single precision, 6e-8 of a metre or radian, is all that could set a cube in
/// motion.
TEST(StillWater, ACubeAtRestStaysForAnHour) {
    for (const Rest& rest : restingCubes()) {
        const AfterAnHour end = restForAnHour(rest, {}, 1);
        EXPECT_LT(end.pose.position.head<2>().norm(), 1e-5) << rest.name;
        EXPECT_LT(end.pose.orientation.angularDistance(rest.orientation), 1e-4) << rest.name;
        EXPECT_LT(end.energyGain, 1e-6) << rest.name;
    }
}

/// Nothing holds a frictionless cube but the accuracy of forces and steps.
TEST(StillWater, ACubeAtRestStaysForAnHourWithoutFriction) {
    BodyDef frictionless;
    frictionless.linearDrag = frictionless.angularDamping = 0;
    for (const Rest& rest : restingCubes()) {
        const AfterAnHour end = restForAnHour(rest, frictionless, 1);
        EXPECT_LT(end.pose.position.head<2>().norm(), 1e-3) << rest.name;
        EXPECT_LT(std::abs(end.energyGain), 1e-6) << rest.name;
        const Vec3 up = rest.orientation.conjugate() * Vec3::UnitZ();
        EXPECT_LT(Vec3(end.pose.orientation.conjugate() * Vec3::UnitZ() - up).norm(), 1e-3) << rest.name;
    }
}

TEST(StillWater, AnHourInFewCallsIsAnHourInMany) {
    for (const Rest& rest : restingCubes()) {
        const AfterAnHour many = restForAnHour(rest, {}, 1), few = restForAnHour(rest, {}, 10);
        EXPECT_EQ(many.pose.position, few.pose.position) << rest.name;
        EXPECT_EQ(many.pose.orientation.coeffs(), few.pose.orientation.coeffs()) << rest.name;
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
