#include <gtest/gtest.h>

#include "bullet_buoyancy/hull/place_part.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "support/compare_results.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/still_water.h"

namespace bullet_buoyancy::test {
namespace {

/// A result sums some hundred triangles, each with some hundred roundings, in one order or another; relative
/// to the whole hull's weight of water, its size and its areas.
constexpr double rounding = 1e-12;
/// What evaluateExact promises of solids of revolution, here of two results: volume and moments, and areas.
constexpr double quadrature = 2e-8;
constexpr double quadratureOfAreas = 2e-5;

constexpr int posesEach = 100;

std::vector<NamedHull> allHulls() {
    std::vector<NamedHull> hulls = polyhedra();
    for (const NamedHull& solid : smoothSolids())
        hulls.push_back(solid);
    return hulls;
}

void expectSame(const HydrostaticResult& a, const HydrostaticResult& b, const Hull& hull, double tolerance,
                double toleranceOfAreas) {
    EXPECT_LE(relativeDifference(a, b, hull, weightDensity), tolerance);
    EXPECT_LE(relativeAreaDifference(a, b, hull), toleranceOfAreas);
}

void expectSame(const HydrostaticResult& a, const HydrostaticResult& b, const Hull& hull) {
    expectSame(a, b, hull, rounding, rounding);
}

/// As seen by somebody who has turned by the inverse.
HydrostaticResult turned(HydrostaticResult result, const Mat3& rotation) {
    for (Vec3* vector : {&result.forceWorld, &result.torqueAboutCom, &result.centreOfBuoyancyFromCom,
                         &result.waterplane.firstMoment})
        *vector = rotation * *vector;
    result.waterplane.secondMoment = rotation * result.waterplane.secondMoment * rotation.transpose();
    return result;
}

TEST(Invariance, MovingAlongTheWaterChangesNothing) {
    Random random(1);
    for (const auto& [name, hull] : allHulls())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const Pose here = atSurface(*hull, random);
            Pose there = here;
            there.position += Vec3{random.uniform(-1e4, 1e4), random.uniform(-1e4, 1e4), 0};
            const HydrostaticResult a = inStillWater(*hull, here), b = inStillWater(*hull, there);
            EXPECT_EQ(a.forceWorld, b.forceWorld);
            EXPECT_EQ(a.torqueAboutCom, b.torqueAboutCom);
            EXPECT_EQ(a.waterplane.secondMoment, b.waterplane.secondMoment);
        }
}

TEST(Invariance, TurningAboutTheVerticalTurnsTheResult) {
    Random random(2);
    for (const auto& [name, hull] : allHulls())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const Pose pose = atSurface(*hull, random);
            const Eigen::Quaterniond yaw = turnedBy(random.uniform(0, 6.3), Vec3::UnitZ());
            const Pose yawed{pose.position, yaw * pose.orientation};
            // The water is seen from the body at the same angle but for rounding.
            expectSame(inStillWater(*hull, yawed), turned(inStillWater(*hull, pose), yaw.toRotationMatrix()),
                       *hull);
        }
}

TEST(Invariance, TurningTheWholeWorldTurnsTheResult) {
    Random random(3);
    for (const auto& [name, hull] : allHulls())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const Pose pose = atSurface(*hull, random);
            const Pose world{random.inCube(10), random.orientation()};
            const FlatWater water(WaterFrame::fromUp(world.position, world.orientation * Vec3::UnitZ()));
            const Pose moved{world.position + world.orientation * pose.position,
                             world.orientation * pose.orientation};
            // Heights are now the differences of coordinates of 10 m.
            expectSame(evaluateExact(*hull, moved, water, everything()),
                       turned(inStillWater(*hull, pose), world.worldFromBody()), *hull, 100 * rounding,
                       100 * rounding);
        }
}

TEST(Invariance, SplittingTrianglesChangesNothing) {
    Random random(4);
    for (const auto& [name, hull] : polyhedra()) {
        const auto split = hullOf(quartered(quartered(hull->mesh)));
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const Pose pose = atSurface(*hull, random);
            expectSame(inStillWater(*split, pose), inStillWater(*hull, pose), *hull);
        }
    }
}

TEST(Invariance, OrderOfTrianglesAndVerticesChangesNothing) {
    Random random(5);
    for (const auto& [name, hull] : polyhedra())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const auto other = hullOf(shuffled(hull->mesh, random));
            const Pose pose = atSurface(*hull, random);
            expectSame(inStillWater(*other, pose), inStillWater(*hull, pose), *hull);
        }
}

TEST(Invariance, ACompoundIsTheSumOfItsParts) {
    Random random(6);
    const std::vector<HullPart> parts{HullPart(boxMesh({1, 0.4, 0.3}, {0, 0.5, 0})),
                                      HullPart(Sphere{{0.5, -0.3, 0.2}, 0.3}),
                                      HullPart(makeCone({-0.5, -0.4, -0.2}, Vec3::UnitZ(), 0.3, 0.6)),
                                      HullPart(makeCylinder({0, -0.2, 0}, Vec3::UnitX(), 0.1, 0.3))};
    const auto whole = hullOf(parts);
    for (int i = 0; i < 10 * posesEach; ++i) {
        const Pose pose = atSurface(*whole, random);
        HydrostaticResult sum;
        Vec3 moment = Vec3::Zero();
        for (const HullPart& part : parts) {
            const HydrostaticResult one = inStillWater(*hullOf(std::vector<HullPart>{part}), pose);
            sum.forceWorld += one.forceWorld;
            sum.torqueAboutCom += one.torqueAboutCom;
            sum.submergedVolume += one.submergedVolume;
            sum.potentialEnergy += one.potentialEnergy;
            sum.wettedArea += one.wettedArea;
            sum.waterplane.area += one.waterplane.area;
            sum.waterplane.firstMoment += one.waterplane.firstMoment;
            sum.waterplane.secondMoment += one.waterplane.secondMoment;
            moment += one.submergedVolume * one.centreOfBuoyancyFromCom;
        }
        if (sum.submergedVolume > 0) sum.centreOfBuoyancyFromCom = moment / sum.submergedVolume;
        // A part that is wholly under goes by its moments where it is alone, and section by section in the
        // whole: the same polynomials for its volume, while areas of ends at the surface are by quadrature.
        expectSame(inStillWater(*whole, pose), sum, *whole, quadrature, quadratureOfAreas);
    }
}

TEST(Invariance, WhereAPartIsPlacedInTheBodyOrTheBodyInTheWorldIsTheSame) {
    Random random(7);
    for (const auto& [name, solid] : smoothSolids())
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const HullPart part =
                solid->spheres.empty() ? HullPart(solid->solids[0]) : HullPart(solid->spheres[0]);
            const Pose inBody{random.inCube(0.5), random.orientation()};
            const auto placedHull = hullOf(std::vector<HullPart>{placed(part, inBody)});
            const Pose body = atSurface(*placedHull, random);
            const Pose direct{body.position + body.orientation * inBody.position,
                              body.orientation * inBody.orientation};
            const HydrostaticResult a = inStillWater(*placedHull, body), b = inStillWater(*solid, direct);
            EXPECT_TRUE(
                isNear(a.forceWorld, b.forceWorld, quadrature * weightDensity * solid->moments.volume));
            EXPECT_NEAR(a.potentialEnergy, b.potentialEnergy,
                        quadrature * weightDensity * solid->moments.volume);
            EXPECT_NEAR(a.wettedArea, b.wettedArea, quadratureOfAreas * solid->surfaceArea);
        }
}

TEST(Invariance, WetPartAndDryPartMakeUpTheWhole) {
    // The dry part is what would be wet if the world were turned over at the surface.
    Random random(8);
    const FlatWater above(WaterFrame::fromUp(Vec3::Zero(), -Vec3::UnitZ()));
    for (const auto& [name, hull] : allHulls()) {
        const bool isMesh = hull->solids.empty();
        const double tolerance = isMesh ? rounding : quadrature;
        const double toleranceOfAreas = isMesh ? rounding : quadratureOfAreas;
        const double size = hull->bounds.radius + hull->bounds.centre.norm();
        for (int i = 0; i < posesEach; ++i) {
            SCOPED_TRACE(name);
            const Pose pose = atSurface(*hull, random);
            const HydrostaticResult wet = inStillWater(*hull, pose);
            const HydrostaticResult dry = evaluateExact(*hull, pose, above, everything());
            const VolumeMoments& all = hull->moments;
            EXPECT_NEAR(wet.submergedVolume + dry.submergedVolume, all.volume, tolerance * all.volume);
            EXPECT_TRUE(isNear(wet.submergedVolume * wet.centreOfBuoyancyFromCom +
                                   dry.submergedVolume * dry.centreOfBuoyancyFromCom,
                               pose.orientation * all.firstMoment, tolerance * all.volume * size));
            EXPECT_NEAR(wet.wettedArea + dry.wettedArea, hull->surfaceArea, toleranceOfAreas * size * size);
            EXPECT_NEAR(wet.waterplane.area, dry.waterplane.area, toleranceOfAreas * size * size);
            EXPECT_TRUE(isNear(wet.waterplane.secondMoment, dry.waterplane.secondMoment,
                               toleranceOfAreas * std::pow(size, 4)));
        }
    }
}

TEST(Continuity, WhereTheHullIsJustUnderOrJustOutTheShortcutsTakeOver) {
    // A hair's breadth to either side of where its bounding sphere touches the surface from below or from
    // above.
    Random random(9);
    for (const auto& [name, hull] : allHulls())
        for (double side : {-1.0, 1.0})
            for (int i = 0; i < posesEach; ++i) {
                SCOPED_TRACE(name);
                const Eigen::Quaterniond orientation = random.orientation();
                const double heightOfCom = -(orientation * hull->bounds.centre).z();
                const double touching = side * hull->bounds.radius, hair = 1e-9 * hull->bounds.radius;
                const auto at = [&, &solid = *hull](double height) {
                    return inStillWater(solid, atHeight(heightOfCom + height, orientation));
                };
                const bool isMesh = hull->solids.empty();
                // Across the hair's breadth depths change by 1e-9 of the size: energies do, for a hull under
                // water.
                expectSame(at(touching - hair), at(touching + hair), *hull,
                           1e-8 + (isMesh ? rounding : quadrature), isMesh ? 1e-8 : quadratureOfAreas);
            }
}

TEST(OpenMesh, WithItsHoleAboveTheWaterFloatsAsIfItWereClosed) {
    Random random(10);
    const TriangleMesh closed = boxMesh({2, 1, 1});
    const auto lidded = hullOf(closed), open = hullOf(without(closed, 10, 2));
    ASSERT_FALSE(open->meshIsClosed);
    ASSERT_TRUE(lidded->meshIsClosed);
    for (int i = 0; i < posesEach; ++i) {
        // Heeled and trimmed by up to 0.2, the lid's corners stay above the surface to a height of 0.5 - 0.3
        // m.
        const Eigen::Quaterniond orientation = turnedBy(random.uniform(-0.2, 0.2), Vec3::UnitX()) *
                                               turnedBy(random.uniform(-0.2, 0.2), Vec3::UnitY());
        const Pose pose = atHeight(random.uniform(-0.15, 0.4), orientation);
        expectSame(inStillWater(*open, pose), inStillWater(*lidded, pose), *lidded);
    }
}

TEST(OpenMesh, AgreesWithTheReferenceEvaluator) {
    Random random(11);
    const std::vector<NamedHull> openHulls{
        {"box without a lid", hullOf(without(boxMesh({2, 1, 1}), 10, 2))},
        {"ball with a hole", hullOf(without(polyhedra()[5].hull->mesh, 40, 20))},
        {"ring with a slit", hullOf(without(ringMesh(0.3, 0.6, 0.2, 12), 0, 8))},
    };
    for (const auto& [name, hull] : openHulls)
        for (int i = 0; i < 5; ++i) {
            SCOPED_TRACE(name);
            const Pose pose = atSurface(*hull, random);
            const HydrostaticResult reference = evaluateReference(*hull, pose, stillWater(), everything());
            // Adaptive quadrature leaves cells of 2^-12 of a triangle's side along the waterline.
            expectSame(inStillWater(*hull, pose), reference, *hull, 1e-6, 1e-3);
        }
}

TEST(OpenMesh, FarUnderWaterStillFeelsThePressureOnTheTrianglesThatAreThere) {
    // A box without its lid: the pressure on the bottom alone, not the weight of what it would enclose.
    const auto open = hullOf(without(boxMesh({2, 1, 1}), 10, 2));
    const double depth = 30, onBottom = weightDensity * 2 * (depth + 0.5);
    const HydrostaticResult result = inStillWater(*open, atHeight(-depth));
    EXPECT_TRUE(isNear(result.forceWorld, onBottom * Vec3::UnitZ(), rounding * onBottom));
}

}  // namespace
}  // namespace bullet_buoyancy::test
