#include "bullet_buoyancy/hydrostatics/stiffness.h"

#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/still_water.h"

namespace bullet_buoyancy::test {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Relative to the whole hull, a hundred roundings.
constexpr double rounding = 1000 * epsilon;

constexpr int posesEach = 50;

double sizeOf(const Hull& hull) {
    return hull.bounds.radius + hull.bounds.centre.norm();
}

/// Displaced along and turned about one of the world's axes, through the centre of mass.
Pose nudged(const Pose& pose, int coordinate, double step) {
    if (coordinate < 3) return {pose.position + step * Vec3::Unit(coordinate), pose.orientation};
    return {pose.position, turnedBy(step, Vec3::Unit(coordinate - 3)) * pose.orientation};
}

Vec6 wrench(const HydrostaticResult& result) {
    Vec6 both;
    both << result.forceWorld, result.torqueAboutCom;
    return both;
}

/// Central differences: off by the square of the step times a third derivative, and by what the evaluator is
/// off, over the step.
template <typename Value>
auto derivative(const Hull& hull, const Pose& pose, int coordinate, double step, const Value& value) {
    const auto ahead = value(inStillWater(hull, nudged(pose, coordinate, step)));
    const auto behind = value(inStillWater(hull, nudged(pose, coordinate, -step)));
    return decltype(ahead)((ahead - behind) / (2 * step));
}

Vec6 energyGradient(const Hull& hull, const Pose& pose, double step) {
    Vec6 gradient;
    for (int i = 0; i < 6; ++i) {
        const double unit = i < 3 ? sizeOf(hull) : 1;
        gradient[i] = derivative(hull, pose, i, step * unit,
                                 [](const HydrostaticResult& result) { return result.potentialEnergy; });
    }
    return gradient;
}

Mat6 wrenchGradient(const Hull& hull, const Pose& pose, double step) {
    Mat6 gradient;
    for (int i = 0; i < 6; ++i) {
        const double unit = i < 3 ? sizeOf(hull) : 1;
        gradient.col(i) = derivative(hull, pose, i, step * unit, wrench);
    }
    return gradient;
}

/// What the largest possible waterplane would do: units of displacement in the hull's size, angles in
/// radians.
Vec6 unitsOf(const Hull& hull) {
    Vec6 units;
    units << Vec3::Ones(), Vec3::Constant(sizeOf(hull));
    return units;
}

/// Calls `visit(hull, pose, step, tolerance)` for all solids in many poses. Differences over a step are off
/// by its square times a third derivative: of polyhedra some tens, but thousands where a blunt corner just
/// dips in; of solids of revolution some hundreds, and their waterplane is promised to 1e-5.
template <typename Visit>
void forManyPoses(const Visit& visit) {
    Random random(1);
    for (const auto& [name, hull] : polyhedra())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            visit(*hull, atSurface(*hull, random), 1e-5, 1e-6);
        }
    for (const auto& [name, hull] : smoothSolids())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            visit(*hull, atSurface(*hull, random), 1e-4, 1e-5);
        }
}

TEST(PotentialEnergy, FallsAlongTheForceAndTheTorque) {
    forManyPoses([](const Hull& hull, const Pose& pose, double step, double tolerance) {
        const Vec6 fall = -energyGradient(hull, pose, step), push = wrench(inStillWater(hull, pose));
        const double unit = weightDensity * std::pow(sizeOf(hull), 3);
        EXPECT_TRUE(isNear(fall.cwiseQuotient(unitsOf(hull)) / unit, push.cwiseQuotient(unitsOf(hull)) / unit,
                           tolerance));
    });
}

TEST(SubmergedVolume, GrowsByTheWaterplaneAsTheBodySinks) {
    forManyPoses([](const Hull& hull, const Pose& pose, double step, double tolerance) {
        const double growth =
            -derivative(hull, pose, 2, step * sizeOf(hull),
                        [](const HydrostaticResult& result) { return result.submergedVolume; });
        EXPECT_NEAR(growth, inStillWater(hull, pose).waterplane.area, tolerance * std::pow(sizeOf(hull), 2));
    });
}

TEST(HydrostaticStiffness, IsTheDerivativeOfForceAndTorque) {
    forManyPoses([](const Hull& hull, const Pose& pose, double step, double tolerance) {
        const Mat6 stiffness = hydrostaticStiffness(inStillWater(hull, pose), Vec3::UnitZ(), weightDensity);
        const Mat6 scale = unitsOf(hull).cwiseInverse().asDiagonal();
        const double unit = weightDensity * std::pow(sizeOf(hull), 2);
        EXPECT_TRUE(isNear(scale * stiffness * scale / unit,
                           -scale * wrenchGradient(hull, pose, step) * scale / unit, tolerance));
    });
}

TEST(HydrostaticStiffness, OfAnUprightBoxIsThatOfNavalArchitects) {
    const double length = 3, beam = 2, draft = 0.8, area = length * beam, volume = area * draft;
    for (double heightOfCom : {0.2, 0.7, 1.6}) {  // above the keel: stable, less so, capsizing
        const auto hull = hullOf(boxMesh({length, beam, 2}, {0, 0, 1 - heightOfCom}));
        const HydrostaticResult result = inStillWater(*hull, atHeight(heightOfCom - draft));
        const double bg = heightOfCom - draft / 2;
        const double gmTransverse = beam * beam / (12 * draft) - bg;
        const double gmLongitudinal = length * length / (12 * draft) - bg;
        Vec6 diagonal;
        diagonal << 0, 0, area, volume * gmTransverse, volume * gmLongitudinal, 0;
        EXPECT_TRUE(isNear(hydrostaticStiffness(result, Vec3::UnitZ(), weightDensity) / weightDensity,
                           Mat6(diagonal.asDiagonal()), 10 * rounding));
    }
}

TEST(HydrostaticStiffness, OfASubmergedBodyIsTheMomentArmAlone) {
    const auto hull = hullOf(boxMesh({1, 1, 1}, {0, 0, 0.3}));
    for (double sign : {1.0, -1.0}) {  // centre of buoyancy above the centre of mass: stable; below: not
        const Pose pose = atHeight(-5, turnedBy(sign > 0 ? 0 : pi, Vec3::UnitX()));
        const Mat6 stiffness = hydrostaticStiffness(inStillWater(*hull, pose), Vec3::UnitZ(), weightDensity);
        Vec6 diagonal;
        diagonal << 0, 0, 0, sign * 0.3, sign * 0.3, 0;
        EXPECT_TRUE(isNear(stiffness / weightDensity, Mat6(diagonal.asDiagonal()), rounding));
    }
}

TEST(HydrostaticStiffness, TurnsWithTheWorld) {
    Random random(2);
    const auto hull = hullOf(boxMesh({1, 0.8, 0.6}, {0.3, -0.2, 0.5}));
    for (int i = 0; i < posesEach; ++i) {
        const Pose pose = atSurface(*hull, random);
        const Eigen::Quaterniond world = random.orientation();
        const Vec3 up = world * Vec3::UnitZ();
        const FlatWater water(WaterFrame::fromUp(Vec3::Zero(), up));
        const HydrostaticResult tilted =
            evaluateExact(*hull, {world * pose.position, world * pose.orientation}, water, everything());
        Mat6 turn = Mat6::Zero();
        turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = world.toRotationMatrix();
        const Mat6 level = hydrostaticStiffness(inStillWater(*hull, pose), Vec3::UnitZ(), weightDensity);
        EXPECT_TRUE(isNear(hydrostaticStiffness(tilted, up, weightDensity) / weightDensity,
                           turn * level * turn.transpose() / weightDensity, 10 * rounding));
    }
}

TEST(HydrostaticStiffness, IsSymmetricWhereTheBodyIsInEquilibrium) {
    // At the surface through its centre a box floats at half its weight: no torque in any of its symmetric
    // positions.
    const auto hull = hullOf(boxMesh({1, 0.8, 0.6}));
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Pose pose = atHeight(0, turnedBy(pi / 2, axis));
        const HydrostaticResult result = inStillWater(*hull, pose);
        EXPECT_TRUE(isNear(result.torqueAboutCom / weightDensity, Vec3::Zero(), rounding));
        const Mat6 stiffness = hydrostaticStiffness(result, Vec3::UnitZ(), weightDensity) / weightDensity;
        EXPECT_TRUE(isNear(stiffness, stiffness.transpose(), rounding));
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
