#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "support/compare_results.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/still_water.h"

namespace bullet_buoyancy::test {
namespace {

/// Relative to numbers of the order of 1: polyhedra and spheres round some hundred times.
constexpr double rounding = 1000 * epsilon;
/// What evaluateExact promises of solids of revolution: volume and moments, and areas.
constexpr double quadrature = 1e-8;
constexpr double quadratureOfAreas = 1e-5;

std::shared_ptr<const Hull> hullOfPart(HullPart part) {
    return hullOf(std::vector<HullPart>{std::move(part)});
}

/// The law of Archimedes for a displaced volume with its centre at `centre` from the centre of mass, in world
/// axes.
void expectArchimedes(const HydrostaticResult& result, double volume, const Vec3& centre, double tolerance) {
    const Vec3 weight = weightDensity * volume * Vec3::UnitZ();
    const double arm = 1 + centre.norm();
    EXPECT_NEAR(result.submergedVolume, volume, tolerance * volume);
    EXPECT_TRUE(isNear(result.centreOfBuoyancyFromCom, centre, tolerance * arm));
    EXPECT_TRUE(isNear(result.forceWorld, weight, tolerance * weight.norm()));
    EXPECT_TRUE(isNear(result.torqueAboutCom, centre.cross(weight), tolerance * weight.norm() * arm));
}

/// Second moments of the waterplane about the point of it that is nearest the centre of mass.
void expectWaterplane(const HydrostaticResult& result, double area, const Vec2& secondMoments,
                      double tolerance) {
    const Mat3& moments = result.waterplane.secondMoment;
    const double size = 1 + secondMoments.sum();
    EXPECT_NEAR(result.waterplane.area, area, tolerance * (1 + area));
    EXPECT_NEAR(moments(0, 0), secondMoments.x(), tolerance * size);
    EXPECT_NEAR(moments(1, 1), secondMoments.y(), tolerance * size);
    EXPECT_NEAR(moments(0, 1), 0, tolerance * size);
}

/// The height at which a hull, so turned, displaces a volume: by bisection.
double heightForVolume(const Hull& hull, const Eigen::Quaterniond& orientation, double volume) {
    double wet = -2 * hull.bounds.radius, dry = 2 * hull.bounds.radius;
    for (int i = 0; i < 60; ++i) {
        const double middle = (wet + dry) / 2;
        const bool tooMuch = inStillWater(hull, atHeight(middle, orientation)).submergedVolume > volume;
        (tooMuch ? wet : dry) = middle;
    }
    return (wet + dry) / 2;
}

TEST(SubmergedHull, IsLiftedByTheWeightOfItsVolumeAtItsCentroid) {
    Random random(1);
    std::vector<NamedHull> hulls = polyhedra();
    for (const NamedHull& solid : smoothSolids())
        hulls.push_back(solid);
    for (const auto& [name, hull] : hulls)
        for (double depth : {1.001, 2.0, 30.0}) {
            SCOPED_TRACE(name);
            const Eigen::Quaterniond orientation = random.orientation();
            const double heightOfCentre = -depth * hull->bounds.radius;
            const Pose pose = atHeight(heightOfCentre - (orientation * hull->bounds.centre).z(), orientation);
            const HydrostaticResult result = inStillWater(*hull, pose);
            const Vec3 centre = orientation * hull->moments.centroid();
            expectArchimedes(result, hull->moments.volume, centre, rounding);
            const double depthOfCentroid = -(pose.position.z() + centre.z());
            EXPECT_NEAR(result.potentialEnergy / (weightDensity * hull->moments.volume), depthOfCentroid,
                        rounding * depth);
            EXPECT_NEAR(result.wettedArea, hull->surfaceArea, rounding * hull->surfaceArea);
            EXPECT_EQ(result.waterplane.area, 0);
        }
}

TEST(DryHull, FeelsNothing) {
    Random random(2);
    for (const auto& [name, hull] : polyhedra()) {
        const Eigen::Quaterniond orientation = random.orientation();
        for (double height : {1.0001, 5.0}) {
            const double z = height * hull->bounds.radius - (orientation * hull->bounds.centre).z();
            const HydrostaticResult result = inStillWater(*hull, atHeight(z, orientation));
            EXPECT_EQ(result.forceWorld, Vec3::Zero()) << name;
            EXPECT_EQ(result.torqueAboutCom, Vec3::Zero()) << name;
            EXPECT_EQ(result.centreOfBuoyancyFromCom, Vec3::Zero()) << name;
            EXPECT_EQ(result.submergedVolume, 0) << name;
            EXPECT_EQ(result.potentialEnergy, 0) << name;
            EXPECT_EQ(result.wettedArea, 0) << name;
        }
    }
}

TEST(UprightBox, DisplacesItsDraft) {
    const double length = 3, beam = 2, height = 1;
    const auto hull = hullOf(boxMesh({length, beam, height}));
    for (double draft : {1e-3, 0.25, 0.5, 0.999}) {
        const HydrostaticResult result = inStillWater(*hull, atHeight(height / 2 - draft));
        const double volume = length * beam * draft;
        expectArchimedes(result, volume, {0, 0, (draft - height) / 2}, rounding);
        EXPECT_NEAR(result.potentialEnergy, weightDensity * length * beam * draft * draft / 2,
                    rounding * weightDensity * volume);
        EXPECT_NEAR(result.wettedArea, length * beam + 2 * draft * (length + beam), rounding * 20);
        expectWaterplane(result, length * beam,
                         {beam * std::pow(length, 3) / 12, length * std::pow(beam, 3) / 12}, rounding);
        EXPECT_TRUE(isNear(result.waterplane.firstMoment, 6 * Vec3(0, 0, draft - height / 2), rounding * 10));
    }
}

TEST(HeeledBox, RightsItselfByTheWallSidedFormula) {
    // Turned about the middle of its waterline, a box keeps its displacement for as long as deck and bottom
    // are clear.
    const double length = 3, beam = 2, draft = 0.8, bm = beam * beam / (12 * draft);
    for (double heightOfCom : {0.2, 0.7, 1.3}) {  // above the keel
        const Vec3 centreOfBox(0, 0, 0.75 - heightOfCom), waterline(0, 0, draft - heightOfCom);
        const auto hull = hullOf(boxMesh({length, beam, 1.5}, centreOfBox));
        const double bg = heightOfCom - draft / 2;
        for (double degrees : {-34.0, -10.0, 0.0, 1e-3, 1.0, 15.0, 34.0}) {
            const double heel = degrees * pi / 180, tangent = std::tan(heel);
            const Eigen::Quaterniond orientation = turnedBy(heel, Vec3::UnitX());
            const HydrostaticResult result =
                inStillWater(*hull, atHeight(-(orientation * waterline).z(), orientation));
            const double volume = length * beam * draft, weight = weightDensity * volume;
            const double gz = std::sin(heel) * (bm * (1 + tangent * tangent / 2) - bg);
            EXPECT_NEAR(result.submergedVolume, volume, rounding * volume);
            EXPECT_TRUE(isNear(result.forceWorld, weight * Vec3::UnitZ(), rounding * weight));
            EXPECT_TRUE(isNear(result.torqueAboutCom, -weight * gz * Vec3::UnitX(), rounding * weight));
            EXPECT_NEAR(result.waterplane.area, length * beam / std::cos(heel), rounding * 10);
        }
    }
}

/// Where a long square log comes to rest: see Reid (1963), Gilbert (1991), Feigel and Fuzailov (2021).
double tiltOfSquareLog(double density) {
    if (density < (3 - std::sqrt(3.0)) / 6) return 0;
    if (density < 0.25) return std::atan(std::sqrt(12 * density * (1 - density) - 2));
    if (density > 9.0 / 32) return pi / 4;
    const double root = std::sqrt(9 - 32 * density);
    return std::atan((3 - root) / (3 + root));
}

TEST(SquareLog, IsFreeOfTorqueAtItsTiltAndDrivenBackToIt) {
    const auto hull = hullOf(boxMesh({1, 1, 1}));
    const auto torqueAt = [&](double tilt, double density) {
        const Eigen::Quaterniond orientation = turnedBy(tilt, Vec3::UnitX());
        const double height = heightForVolume(*hull, orientation, density);
        return inStillWater(*hull, atHeight(height, orientation)).torqueAboutCom.x() / weightDensity;
    };
    for (double density : {0.1, 0.2, 0.22, 0.23, 0.24, 0.25, 0.26, 0.27, 0.28, 0.3, 0.5}) {
        const double tilt = tiltOfSquareLog(density);
        EXPECT_NEAR(torqueAt(tilt, density), 0, rounding) << density;
        EXPECT_LT(torqueAt(tilt + 0.03, density), 0) << density;
        EXPECT_GT(torqueAt(tilt - 0.03, density), 0) << density;
        if (tilt > 0) {
            EXPECT_GT(torqueAt(0.03, density), 0) << density << ": flat is not stable";
        }
        // The mirror of density, water and air changed places, floats alike.
        EXPECT_NEAR(torqueAt(tilt, 1 - density), 0, rounding) << density;
        EXPECT_LT(torqueAt(tilt + 0.03, 1 - density), 0) << density;
    }
    for (const auto& [density, degrees] :
         {std::pair(0.22, 13.675), std::pair(0.23, 19.486), std::pair(0.24, 23.485), std::pair(0.25, 26.565),
          std::pair(0.26, 29.631), std::pair(0.27, 33.690), std::pair(0.28, 41.186)})
        EXPECT_NEAR(tiltOfSquareLog(density) * 180 / pi, degrees, 1e-3) << "published to three decimals";
}

TEST(Cube, OfHalfTheDensityOfWaterIsStableOnItsCorner) {
    const auto hull = hullOf(boxMesh({1, 1, 1}));
    const auto cornerUp = Eigen::Quaterniond::FromTwoVectors(Vec3::Ones(), Vec3::UnitZ());
    const HydrostaticResult result = inStillWater(*hull, atHeight(0, cornerUp));
    const double bg = 13 / (32 * std::sqrt(3.0)), gm = std::sqrt(3.0) / 48;
    expectArchimedes(result, 0.5, {0, 0, -bg}, rounding);
    // The waterplane is a regular hexagon of side 1 / sqrt 2: the same second moment, 5 sqrt 3 / 16 side^4,
    // any way.
    EXPECT_NEAR(result.waterplane.area, 3 * std::sqrt(3.0) / 4, rounding);
    for (double angle : {0.0, 0.3, 1.0, 2.0}) {
        const Vec3 across(std::cos(angle), std::sin(angle), 0);
        const double bm = across.dot(result.waterplane.secondMoment * across) / result.submergedVolume;
        EXPECT_NEAR(bm - bg, gm, rounding);
    }
}

TEST(Ball, DisplacesACap) {
    const double r = 0.7;
    const auto hull = hullOfPart(Sphere{{0.2, -0.1, 0.3}, r});
    Random random(3);
    for (double immersion : {1e-6, 0.1, 0.7, 1.2, 1.4 - 1e-9}) {
        const Eigen::Quaterniond orientation = random.orientation();
        const Vec3 toCentre = orientation * hull->spheres[0].centre;
        const HydrostaticResult result =
            inStillWater(*hull, atHeight(r - immersion - toCentre.z(), orientation));
        const double h = immersion, volume = pi * h * h * (r - h / 3);
        const double fromCentre = 3 * std::pow(2 * r - h, 2) / (4 * (3 * r - h));
        // A shallow cap is the small difference of heights of the order of 1.
        const double tolerance = rounding / std::min(1.0, h);
        expectArchimedes(result, volume, toCentre - fromCentre * Vec3::UnitZ(), tolerance);
        EXPECT_NEAR(result.potentialEnergy, weightDensity * pi * std::pow(h, 3) * (r / 3 - h / 12),
                    tolerance * weightDensity * volume);
        EXPECT_NEAR(result.wettedArea, 2 * pi * r * h, rounding);
        EXPECT_NEAR(result.waterplane.area, pi * h * (2 * r - h), rounding);
    }
}

TEST(Ball, HalfUnderHasItsCentreOfBuoyancyThreeEighthsDown) {
    for (double r : {0.01, 1.0, 50.0}) {
        const auto hull = hullOfPart(Sphere{Vec3::Zero(), r});
        const HydrostaticResult result = inStillWater(*hull, atHeight(0));
        EXPECT_NEAR(result.submergedVolume / std::pow(r, 3), 2 * pi / 3, rounding);
        EXPECT_TRUE(isNear(result.centreOfBuoyancyFromCom / r, Vec3(0, 0, -3.0 / 8), rounding));
        EXPECT_TRUE(isNear(result.waterplane.secondMoment / std::pow(r, 4),
                           pi / 4 * Vec3(1, 1, 0).asDiagonal().toDenseMatrix(), rounding));
    }
}

TEST(Ball, TendsToItsFormulaAsTrianglesShrink) {
    // The missing volume falls with the square of the triangles' size, and so does the error of all results.
    const Sphere sphere{{0.1, 0, -0.2}, 0.5};
    const auto truth = hullOfPart(sphere);
    const Pose pose = atHeight(0.1, turnedBy(0.7, Vec3(1, 2, 2) / 3));
    const auto error = [&](int levels) {
        const auto mesh = hullOf(tessellate(sphere, levels));
        return relativeDifference(inStillWater(*mesh, pose), inStillWater(*truth, pose), *truth,
                                  weightDensity);
    };
    EXPECT_NEAR(error(3) / error(4), 4, 0.2);
}

TEST(UprightCylinder, DisplacesItsDraft) {
    const double r = 0.8, height = 2;
    const auto hull = hullOfPart(makeCylinder(Vec3::Zero(), Vec3::UnitZ(), r, height / 2));
    for (bool upsideDown : {false, true})
        for (double draft : {1e-3, 0.5, 1.3}) {
            const Eigen::Quaterniond orientation = turnedBy(upsideDown ? pi : 0, Vec3::UnitX());
            const HydrostaticResult result = inStillWater(*hull, atHeight(height / 2 - draft, orientation));
            expectArchimedes(result, pi * r * r * draft, {0, 0, (draft - height) / 2}, quadrature);
            EXPECT_NEAR(result.potentialEnergy, weightDensity * pi * r * r * draft * draft / 2,
                        quadrature * weightDensity);
            EXPECT_NEAR(result.wettedArea, pi * r * r + 2 * pi * r * draft, quadratureOfAreas);
            expectWaterplane(result, pi * r * r, Vec2::Constant(pi / 4 * std::pow(r, 4)), quadratureOfAreas);
        }
}

TEST(TiltedCylinder, HasAnEllipseForWaterplane) {
    // As for the heeled box: turned about the middle of its waterline, with both ends clear of the surface.
    const double r = 0.5, length = 3, draft = 1.6;
    const Vec3 waterline(0, 0, draft - length / 2);
    const auto hull = hullOfPart(makeCylinder(Vec3::Zero(), Vec3::UnitZ(), r, length / 2));
    for (double degrees : {1e-9, 1e-6, 1e-3, 0.1, 5.0, 20.0, 45.0, 70.0}) {
        SCOPED_TRACE(degrees);
        const double tilt = degrees * pi / 180, tangent = std::tan(tilt), cosine = std::cos(tilt);
        const Eigen::Quaterniond orientation = turnedBy(tilt, Vec3::UnitX());
        const HydrostaticResult result =
            inStillWater(*hull, atHeight(-(orientation * waterline).z(), orientation));
        // Wedges change sides: the centre moves by their moments over the volume.
        const Vec3 centre(0, -r * r * tangent / (4 * draft),
                          (draft - length) / 2 + r * r * tangent * tangent / (8 * draft));
        expectArchimedes(result, pi * r * r * draft, orientation * centre, quadrature);
        EXPECT_NEAR(result.waterplane.area, pi * r * r / cosine, quadratureOfAreas);
        EXPECT_NEAR(result.waterplane.secondMoment(0, 0), pi / 4 * std::pow(r, 4) / cosine,
                    quadratureOfAreas);
        const double alongTilt = pi / 4 * std::pow(r, 4) / std::pow(cosine, 3);
        const double distance = (orientation * waterline).y();
        EXPECT_NEAR(result.waterplane.secondMoment(1, 1),
                    alongTilt + distance * distance * pi * r * r / cosine, quadratureOfAreas * 4);
        // Unrolled, the waterline is a sine about its mean: the side is as wet as upright.
        EXPECT_NEAR(result.wettedArea, 2 * pi * r * draft + pi * r * r, quadratureOfAreas * 9);
    }
}

TEST(LyingCylinder, DisplacesACircularSegment) {
    const double r = 0.5, length = 3;
    const auto hull = hullOfPart(makeCylinder(Vec3::Zero(), Vec3::UnitX(), r, length / 2));
    for (double depth : {-0.4, -0.1, 0.0, 0.25, 0.499}) {  // of the axis
        const double angle = 2 * std::acos(-depth / r);    // that the wet arc is seen under
        const double segment = r * r / 2 * (angle - std::sin(angle));
        const double fromAxis = 4 * r * std::pow(std::sin(angle / 2), 3) / (3 * (angle - std::sin(angle)));
        const double chord = 2 * r * std::sin(angle / 2);
        const HydrostaticResult result = inStillWater(*hull, atHeight(-depth));
        expectArchimedes(result, segment * length, {0, 0, -fromAxis}, quadrature);
        EXPECT_NEAR(result.potentialEnergy, weightDensity * segment * length * (depth + fromAxis),
                    quadrature * weightDensity);
        EXPECT_NEAR(result.wettedArea, r * angle * length + 2 * segment, quadratureOfAreas * 9);
        expectWaterplane(result, chord * length,
                         {chord * std::pow(length, 3) / 12, length * std::pow(chord, 3) / 12},
                         quadratureOfAreas * 9);
    }
}

TEST(LyingCylinder, HalfUnderHasTheHalfDiscsCentre) {
    const double r = 0.5, length = 3;
    const auto hull = hullOfPart(makeCylinder(Vec3::Zero(), Vec3::UnitX(), r, length / 2));
    const HydrostaticResult result = inStillWater(*hull, atHeight(0));
    expectArchimedes(result, pi * r * r * length / 2, {0, 0, -4 * r / (3 * pi)}, quadrature);
}

TEST(ConeTipDown, DisplacesTheCubeOfItsDraft) {
    const double height = 1.5, k = 0.4;  // radius per height
    const auto hull = hullOfPart(makeCone({0, 0, height}, -Vec3::UnitZ(), k * height, height));
    for (double draft : {0.01, 0.3, 1.0, 1.49}) {
        const HydrostaticResult result =
            inStillWater(*hull, atHeight(-draft));  // the tip is the centre of mass
        expectArchimedes(result, pi / 3 * k * k * std::pow(draft, 3), {0, 0, 3 * draft / 4}, quadrature);
        EXPECT_NEAR(result.potentialEnergy, weightDensity * pi / 12 * k * k * std::pow(draft, 4),
                    quadrature * weightDensity * std::pow(draft, 3));
        EXPECT_NEAR(result.wettedArea, pi * k * std::sqrt(1 + k * k) * draft * draft, quadratureOfAreas);
        const double radius = k * draft;
        expectWaterplane(result, pi * radius * radius, Vec2::Constant(pi / 4 * std::pow(radius, 4)),
                         quadratureOfAreas);
    }
}

TEST(TaperedCapsule, AlmostABallFloatsAsTheBall) {
    const auto ball = hullOfPart(asSolidOfRevolution(Sphere{Vec3::Zero(), 0.5}));
    Random random(4);
    for (double margin : {1e-7, 1e-9, 1e-12, 1e-15}) {
        const auto hull =
            hullOfPart(makeTaperedCapsule(Vec3::Zero(), 0.5, (0.3 + margin) * Vec3::UnitX(), 0.2));
        for (int i = 0; i < 100; ++i) {
            const Pose pose = atSurface(*ball, random);
            const double difference = relativeDifference(inStillWater(*hull, pose), inStillWater(*ball, pose),
                                                         *ball, weightDensity);
            EXPECT_LT(difference, quadrature + margin) << margin;
        }
    }
}

TEST(WigleyHull, TendsToItsFormulasAsItsPanelsShrink) {
    const double length = 1, beam = 0.1, draft = 0.0625;
    const double volume = 4.0 / 9 * length * beam * draft;
    struct Errors {
        double volume, area, centre, transverse, longitudinal, wetted;
    };
    const auto errors = [&](int stations, int waterlines) {
        const auto hull = hullOf(wigleyMesh(length, beam, draft, stations, waterlines));
        const HydrostaticResult result = inStillWater(*hull, atHeight(0));
        const Mat3& secondMoment = result.waterplane.secondMoment;
        return Errors{result.submergedVolume / volume - 1,
                      result.waterplane.area / (2.0 / 3 * length * beam) - 1,
                      result.centreOfBuoyancyFromCom.z() / (-3.0 / 8 * draft) - 1,
                      secondMoment(1, 1) / (4.0 / 105 * length * std::pow(beam, 3)) - 1,
                      secondMoment(0, 0) / (1.0 / 30 * beam * std::pow(length, 3)) - 1,
                      result.wettedArea / 0.1487906 - 1};
    };
    const Errors coarse = errors(40, 10), fine = errors(80, 20);
    // The error of second order falls to a quarter; one of fourth order, 5 % of it at 10 waterlines, does not
    // disturb.
    EXPECT_NEAR(coarse.volume / fine.volume, 4, 0.2);
    EXPECT_NEAR(coarse.area / fine.area, 4, 0.2);
    EXPECT_NEAR(coarse.centre / fine.centre, 4, 0.2);
    EXPECT_NEAR(coarse.transverse / fine.transverse, 4, 0.2);
    EXPECT_NEAR(coarse.longitudinal / fine.longitudinal, 4, 0.2);
    EXPECT_NEAR(coarse.wetted / fine.wetted, 4, 0.2);
    // Extrapolated (Richardson), each is right to the fourth order, the wetted area to its seven published
    // digits.
    for (double Errors::*error : {&Errors::volume, &Errors::area, &Errors::centre, &Errors::transverse,
                                  &Errors::longitudinal, &Errors::wetted})
        EXPECT_NEAR((4 * fine.*error - coarse.*error) / 3, 0, 0.05 * std::abs(fine.*error) + 5e-7);
}

TEST(SparOfOc3, HasThePublishedVolumeAndCentre) {
    // Jonkman, NREL/TP-500-47535: a cylinder to 4 m of depth, a cone to 12 m, a cylinder to the keel at 120
    // m.
    const double slope = (4.7 - 3.25) / 8, tip = 3.25 - 4 * slope;  // of the cone's lines, at depth 0
    const SolidOfRevolution spar{Vec3::Zero(),
                                 -Vec3::UnitZ(),
                                 {{-10, 4, 3.25 * 3.25, 0, 0},
                                  {4, 12, tip * tip, 2 * tip * slope, slope * slope},
                                  {12, 120, 4.7 * 4.7, 0, 0}}};
    const HydrostaticResult result = inStillWater(*hullOfPart(spar), atHeight(0));
    EXPECT_NEAR(result.submergedVolume, 8029.21, 0.005) << "published to two decimals";
    EXPECT_NEAR(result.centreOfBuoyancyFromCom.z(), -62.066, 0.0005) << "published to three decimals";
    EXPECT_NEAR(result.waterplane.area, pi * 3.25 * 3.25, quadratureOfAreas * 3.25 * 3.25);
}

TEST(HydrostaticQuery, CostsAndFillsOnlyWhatIsAskedFor) {
    const auto hull = hullOf(boxMesh({1, 1, 1}));
    const HydrostaticResult plain = evaluateExact(*hull, atHeight(0.1), stillWater());
    EXPECT_EQ(plain.wettedArea, 0);
    EXPECT_EQ(plain.waterplane.area, 0);
    const HydrostaticResult all = inStillWater(*hull, atHeight(0.1));
    EXPECT_EQ(plain.forceWorld, all.forceWorld);
    EXPECT_EQ(plain.torqueAboutCom, all.torqueAboutCom);
    EXPECT_EQ(plain.potentialEnergy, all.potentialEnergy);
}

TEST(HydrostaticQuery, ScalesWithGravityAndDensity) {
    const auto hull = hullOf(boxMesh({1, 1, 1}, {0.2, 0.1, 0}));
    const Pose pose = atHeight(0.1, turnedBy(0.4, Vec3::UnitY()));
    const HydrostaticResult earth = evaluateExact(*hull, pose, stillWater());
    HydrostaticQuery query;
    query.gravity = 1.62;
    const FlatWater sea(WaterFrame::zUp(), {seaWaterDensity, Vec3::Zero()});
    const HydrostaticResult moon = evaluateExact(*hull, pose, sea, query);
    const double ratio = seaWaterDensity * 1.62 / weightDensity;
    EXPECT_TRUE(isNear(moon.forceWorld, ratio * earth.forceWorld, rounding * earth.forceWorld.norm()));
    EXPECT_TRUE(
        isNear(moon.torqueAboutCom, ratio * earth.torqueAboutCom, rounding * earth.forceWorld.norm()));
    EXPECT_NEAR(moon.potentialEnergy, ratio * earth.potentialEnergy, rounding * earth.potentialEnergy);
    EXPECT_EQ(moon.submergedVolume, earth.submergedVolume);
}

}  // namespace
}  // namespace bullet_buoyancy::test
