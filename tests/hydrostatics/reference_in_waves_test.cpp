#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/core/quadrature.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/hydrostatics/reference_waves.h"
#include "support/compare_results.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/quadratic_water.h"
#include "support/sine_water.h"
#include "support/still_water.h"

namespace bullet_buoyancy::test {
namespace {

/// What evaluateReference promises in waves, of force, moments and energy and of areas.
constexpr double promised = 1e-8;
constexpr double promisedOfAreas = 1e-6;

/// sin(x) / x
double sinc(double x) {
    return x == 0 ? 1 : std::sin(x) / x;
}

std::shared_ptr<const Hull> hullOfPart(HullPart part) {
    return hullOf(std::vector<HullPart>{std::move(part)});
}

std::vector<NamedHull> allHulls() {
    std::vector<NamedHull> hulls = polyhedra();
    for (const NamedHull& solid : smoothSolids())
        hulls.push_back(solid);
    return hulls;
}

/// Waves of 3 m to 20 m from several sides, of a slope up to 0.16: no plane to a hull of 1 m.
const SineWater& seaway() {
    static const SineWater water({{0.10, {0.3, 0.1}, 1.8, 0.4},
                                  {0.06, {0.5, -0.6}, 2.8, 1.9},
                                  {0.03, {-0.4, 1.1}, 3.4, 4.0},
                                  {0.02, {2.0, 0.7}, 4.6, 2.5}});
    return water;
}

/// Turned at random, at a random place of the seaway, at or near its surface.
Pose inSeaway(const Hull& hull, Random& random) {
    Pose pose = atSurface(hull, random);
    pose.position.head<2>() = random.inCube(20).head<2>();
    return pose;
}

HydrostaticQuery at(double time, PressureModel model = PressureModel::hydrostatic) {
    HydrostaticQuery query = everything();
    query.time = time;
    query.pressure = model;
    return query;
}

/// Of a hull's whole displacement, N, and that times its size, N m.
double weightOfAll(const Hull& hull) {
    return weightDensity * hull.moments.volume;
}
double momentOfAll(const Hull& hull) {
    return weightOfAll(hull) * (hull.bounds.radius + hull.bounds.centre.norm());
}

/// Depth below a tilted plane is sqrt(1 + slope^2) times the distance from it: water at rest under a gravity
/// stronger by that and along the plane's normal.
struct TiltedPlane {
    Vec2 slope{0.2, -0.35};
    double steepness = std::sqrt(1 + slope.squaredNorm());
    QuadraticWater water{0.1, slope};
    FlatWater asFlat{WaterFrame::fromUp({0, 0, 0.1}, {-slope.x(), -slope.y(), 1})};

    HydrostaticResult reference(const Hull& hull, const Pose& pose) const {
        HydrostaticQuery query = everything();
        query.stiffness = true;
        return evaluateReference(hull, pose, water, query);
    }

    /// Where the sheared vertical matters not: the waterplane is level, so smaller.
    HydrostaticResult exact(const Hull& hull, const Pose& pose) const {
        HydrostaticQuery query = everything();
        query.stiffness = true;
        query.gravity *= steepness;
        HydrostaticResult result = evaluateExact(hull, pose, asFlat, query);
        result.waterplane.area /= steepness;
        result.waterplane.firstMoment /= steepness;
        result.waterplane.secondMoment /= steepness;
        return result;
    }
};

TEST(ReferenceInWaves, ATiltedPlaneIsFlatWaterInAWorldThatLeans) {
    const TiltedPlane tilted;
    Random random(1);
    for (const auto& [name, hull] : allHulls())
        for (int i = 0; i < 5; ++i) {
            SCOPED_TRACE(name);
            const Pose pose = atSurface(*hull, random);
            const HydrostaticResult reference = tilted.reference(*hull, pose);
            const HydrostaticResult exact = tilted.exact(*hull, pose);
            // evaluateExact adds its own quadrature of solids.
            EXPECT_LT(relativeDifference(reference, exact, *hull, weightDensity), 2 * promised + 2e-8);
            EXPECT_LT(relativeAreaDifference(reference, exact, *hull), promisedOfAreas + 1e-5);
            EXPECT_LT(relativeStiffnessDifference(reference, exact, *hull, weightDensity),
                      2 * (promisedOfAreas + 1e-5));
        }
}

TEST(ReferenceInWaves, OpenMeshesFeelATiltedPlaneToo) {
    const TiltedPlane tilted;
    Random random(2);
    const auto hull = hullOf(without(boxMesh({2, 1, 1}), 10, 2));
    ASSERT_FALSE(hull->meshIsClosed);
    for (int i = 0; i < 20; ++i) {
        const Pose pose = atSurface(*hull, random);
        const HydrostaticResult reference = tilted.reference(*hull, pose);
        const HydrostaticResult exact = tilted.exact(*hull, pose);
        // What an open mesh encloses depends on the direction in which one looks into it; forces do not.
        EXPECT_TRUE(isNear(reference.forceWorld, exact.forceWorld, promised * weightOfAll(*hull)));
        EXPECT_TRUE(isNear(reference.torqueAboutCom, exact.torqueAboutCom, promised * momentOfAll(*hull)));
        EXPECT_NEAR(reference.wettedArea, exact.wettedArea, promisedOfAreas * hull->surfaceArea);
    }
}

TEST(ReferenceInWaves, WavesThatVanishAreFlatWater) {
    Random random(3);
    for (PressureModel model : {PressureModel::hydrostatic, PressureModel::waveDynamic})
        for (const auto& [name, hull] : allHulls()) {
            SCOPED_TRACE(name);
            const double size = hull->bounds.radius + hull->bounds.centre.norm();
            const SineWater water({waveAlongX(1e-12 * size, 1)});
            const Pose pose = inSeaway(*hull, random);
            const HydrostaticResult reference = evaluateReference(*hull, pose, water, at(0, model));
            const HydrostaticResult flat = inStillWater(*hull, pose);
            EXPECT_LT(relativeDifference(reference, flat, *hull, weightDensity), promised + 2e-8);
            EXPECT_LT(relativeAreaDifference(reference, flat, *hull), promisedOfAreas + 1e-5);
        }
}

/// Hydrostatic: force = -rho g integral of grad(head). The head of one wave, a cos(kx - wt) - z.
Vec3 forceUnderWave(double volume, double amplitude, double waveNumber, double meanSine) {
    return weightDensity * volume * Vec3(amplitude * waveNumber * meanSine, 0, 1);
}

TEST(ReferenceInWaves, ASubmergedBoxFeelsTheMeanSlopeOfTheWave) {
    Random random(4);
    const Vec3 size(1.0, 0.8, 0.6);
    const auto hull = hullOf(boxMesh(size));
    const double amplitude = 0.3, k = 0.9, time = 1.3;
    const SineWave wave = waveAlongX(amplitude, k);
    const SineWater water({wave});
    for (int i = 0; i < 20; ++i) {
        const Pose pose{Vec3(random.uniform(-9, 9), 2, -1.5), random.orientation()};
        const Vec3 kInBody = pose.orientation.inverse() * Vec3(k, 0, 0);
        double mean = std::sin(k * pose.position.x() - wave.frequency * time);
        for (int axis = 0; axis < 3; ++axis)
            mean *= sinc(kInBody[axis] * size[axis] / 2);
        const HydrostaticResult result = evaluateReference(*hull, pose, water, at(time));
        EXPECT_TRUE(isNear(result.forceWorld, forceUnderWave(size.prod(), amplitude, k, mean),
                           promised * weightOfAll(*hull)));
        EXPECT_NEAR(result.waterplane.area, 0, 100 * epsilon) << "the sum of the faces of a closed box";
    }
}

TEST(ReferenceInWaves, ASubmergedSphereFeelsTheMeanSlopeOfTheWave) {
    const double radius = 0.7, amplitude = 0.3, k = 1.6, kR = k * radius;
    const auto hull = hullOfPart(Sphere{Vec3::Zero(), radius});
    const SineWater water({waveAlongX(amplitude, k)});
    for (double x : {-1.7, 0.0, 0.9}) {
        const double mean = 3 * (std::sin(kR) - kR * std::cos(kR)) / (kR * kR * kR) * std::sin(k * x);
        const HydrostaticResult result =
            evaluateReference(*hull, {{x, 0.4, -1.2}, turnedBy(1, Vec3::UnitY())}, water, at(0));
        EXPECT_TRUE(isNear(result.forceWorld, forceUnderWave(hull->moments.volume, amplitude, k, mean),
                           promised * weightOfAll(*hull)));
        // Pressure acts on a sphere through its centre.
        EXPECT_TRUE(isNear(result.torqueAboutCom, Vec3::Zero(), promised * momentOfAll(*hull)));
    }
}

/// A box with upright walls between crest and bottom, its middle at x = 0 and the body's origin in its
/// middle.
TEST(ReferenceInWaves, AnUprightBoxDisplacesTheWaveOverItsSection) {
    const Vec3 size(2.0, 0.8, 1.6);
    const double amplitude = 0.3, k = 1.1, area = size.x() * size.y(), half = size.z() / 2;
    const auto hull = hullOf(boxMesh(size));
    for (double phase : {0.0, 0.7, 2.9}) {
        SCOPED_TRACE(phase);
        const SineWater water({waveAlongX(amplitude, k, phase)});
        const HydrostaticResult result = evaluateReference(*hull, atHeight(0), water, at(0));
        const auto depthOfBottom = [&](double x) { return half + amplitude * std::cos(k * x + phase); };
        const double left = depthOfBottom(-size.x() / 2), right = depthOfBottom(size.x() / 2);
        const double meanElevation = amplitude * sinc(k * size.x() / 2) * std::cos(phase);
        const double volume = area * (half + meanElevation);
        const Vec3 force = weightDensity * Vec3(size.y() / 2 * (left * left - right * right), 0, volume);
        EXPECT_TRUE(isNear(result.forceWorld, force, promised * weightOfAll(*hull)));
        EXPECT_NEAR(result.submergedVolume, volume, promised * hull->moments.volume);
        EXPECT_NEAR(result.waterplane.area, area, promisedOfAreas * area);
        EXPECT_NEAR(result.wettedArea,
                    area + size.y() * (left + right) + 2 * size.x() * (half + meanElevation),
                    promisedOfAreas * hull->surfaceArea);
        // Mean of depth^2 / 2 over the section.
        const double meanSquare = half * half + 2 * half * meanElevation +
                                  amplitude * amplitude / 2 * (1 + sinc(k * size.x()) * std::cos(2 * phase));
        EXPECT_NEAR(result.potentialEnergy, weightDensity * area * meanSquare / 2,
                    promised * momentOfAll(*hull));
    }
}

/// Polynomials throughout: rules of degree nine are exact but for the waterline.
TEST(ReferenceInWaves, AnUprightBoxInABowl) {
    const Vec3 size(1.2, 0.8, 1.0), half = size / 2;
    const Vec2 bend(0.3, -0.2);
    const double height = 0.1, area = size.x() * size.y();
    const QuadraticWater water(height, Vec2::Zero(), bend);
    const auto hull = hullOf(boxMesh(size));
    const HydrostaticResult result = evaluateReference(*hull, atHeight(0), water, everything());
    const double xx = half.x() * half.x() / 3, yy = half.y() * half.y() / 3;  // means of squares
    const double volume = area * (half.z() + height + (bend.x() * xx + bend.y() * yy) / 2);
    EXPECT_NEAR(result.submergedVolume, volume, promised * size.prod());
    EXPECT_TRUE(
        isNear(result.forceWorld, weightDensity * volume * Vec3::UnitZ(), promised * weightOfAll(*hull)));
    EXPECT_NEAR(result.waterplane.area, area, promisedOfAreas * area);
    EXPECT_NEAR(result.waterplane.secondMoment(0, 0), area * xx, promisedOfAreas * area);
    EXPECT_NEAR(result.waterplane.secondMoment(1, 1), area * yy, promisedOfAreas * area);
    EXPECT_NEAR(result.waterplane.firstMoment.z(), volume - area * half.z(), promisedOfAreas * area);
}

TEST(ReferenceInWaves, ASphereInABowl) {
    // Dry is what lies between the sphere and the paraboloid z = height + bend r^2 / 2 inside the circle
    // where they meet, r^2 = 1 - z^2.
    const double height = -0.2, bend = 0.6;
    const double z = (-1 + std::sqrt(1 + bend * (2 * height + bend))) / bend;
    const double rr = 1 - z * z;
    const double dry = 2 * pi * ((1 - z * z * z) / 3 - height * rr / 2 - bend * rr * rr / 8);
    const QuadraticWater water(height, Vec2::Zero(), Vec2::Constant(bend));
    const auto hull = hullOfPart(Sphere{Vec3::Zero(), 1});
    const HydrostaticResult result =
        evaluateReference(*hull, atHeight(0, turnedBy(0.8, Vec3(0.6, 0, 0.8))), water, everything());
    EXPECT_NEAR(result.submergedVolume, 4 * pi / 3 - dry, promised * hull->moments.volume);
    EXPECT_NEAR(result.wettedArea, 2 * pi * (1 + z), promisedOfAreas);
    EXPECT_NEAR(result.waterplane.area, pi * rr, promisedOfAreas);
    EXPECT_NEAR(result.waterplane.secondMoment(0, 0), pi * rr * rr / 4, promisedOfAreas);
    EXPECT_NEAR(result.forceWorld.z(), weightDensity * result.submergedVolume,
                2 * promised * weightOfAll(*hull));
}

TEST(ReferenceInWaves, SmallWavesLoadAShipAsFroudeAndKrylovSay) {
    // A box of draft T about the middle of its waterline, in the deep-water wave a cos(kx - wt).
    const double length = 2, beam = 0.8, draft = 0.6, k = 1.3, a = 1e-3;
    const auto hull = hullOf(boxMesh({length, beam, 2 * draft}));
    const double e = std::exp(-k * draft), sine = std::sin(k * length / 2), cosine = std::cos(k * length / 2);
    const double ix = 2 * (sine / (k * k) - length / 2 * cosine / k);
    const double j = (1 - e * (1 + k * draft)) / (k * k);
    const HydrostaticQuery query = at(0, PressureModel::waveDynamic);
    for (double wt : {0.0, 0.6, 1.9}) {
        SCOPED_TRACE(wt);
        const SineWater up({waveAlongX(a, k, -wt)}), down({waveAlongX(-a, k, -wt)});
        const HydrostaticResult crest = evaluateReference(*hull, atHeight(0), up, query);
        const HydrostaticResult trough = evaluateReference(*hull, atHeight(0), down, query);
        const Vec3 force = (crest.forceWorld - trough.forceWorld) / (2 * a * weightDensity);
        const Vec3 torque = (crest.torqueAboutCom - trough.torqueAboutCom) / (2 * a * weightDensity);
        // The difference doubles the promised errors, and leaves what is of third order, (k a)^2.
        const double tolerance = promised * hull->moments.volume / a + length * beam * (k * a) * (k * a);
        EXPECT_NEAR(force.z(), beam * length * sinc(k * length / 2) * e * std::cos(wt), tolerance);
        EXPECT_NEAR(force.x(), -2 * beam * sine * (1 - e) / k * std::sin(wt), tolerance);
        EXPECT_NEAR(torque.y(), -beam * (e * ix - 2 * sine * j) * std::sin(wt), tolerance * length);
    }
}

/// -rho g times the integral of grad(head) over what an upright box about the origin, with its walls' tops
/// above the waves, displaces: by Gauss quadrature over its columns, from the derivatives that the field
/// tells.
Vec3 forceOnColumns(const SineWater& water, const Vec3& size) {
    static const GaussLegendre<12> rule;
    const auto count = std::size_t(12);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            const Vec2 place(size.x() / 2 * rule.nodes[i], size.y() / 2 * rule.nodes[j]);
            Eigen::ArrayX2d point = place.transpose().array();
            Eigen::ArrayX3d surface(1, 3);
            water.sampleSurface(point, 0, surface);
            const double half = (surface(0, 0) + size.z() / 2) / 2;
            for (std::size_t k = 0; k < count; ++k) {
                const double s = half * (rule.nodes[k] - 1);
                Eigen::ArrayX3d below(1, 3);
                below << place.x(), place.y(), s;
                Eigen::Array<double, Eigen::Dynamic, 10> f(1, 10);
                water.expandWaveHead(below, 0, f);
                // s = z - elevation
                const Vec3 gradient(f(0, 1) - f(0, 3) * surface(0, 1), f(0, 2) - f(0, 3) * surface(0, 2),
                                    f(0, 3) - 1);
                sum -= rule.weights[i] * rule.weights[j] * rule.weights[k] * half * gradient;
            }
        }
    return weightDensity * size.x() * size.y() / 4 * sum;
}

TEST(ReferenceInWaves, PressureOfWavesOnAFloatingBoxIsItsGradientOverTheDisplacement) {
    const Vec3 size(1.6, 1.1, 1.4);
    const auto hull = hullOf(boxMesh(size));
    const SineWater water({{0.2, {0.9, 0.3}, 0, 0.4}, {0.1, {-0.7, 1.6}, 0, 2.0}});
    const HydrostaticResult result =
        evaluateReference(*hull, atHeight(0), water, at(0, PressureModel::waveDynamic));
    // The rule of 12 points leaves (k L / 4)^24 / 24! of the head, nothing in double precision.
    EXPECT_TRUE(isNear(result.forceWorld, forceOnColumns(water, size), promised * weightOfAll(*hull)));
}

/// Central differences of fourth order.
template <typename Function>
double slopeOf(const Function& f, double step) {
    return (8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step);
}

TEST(ReferenceInWaves, ForceAndTorqueAreTheSlopeOfThePotential) {
    Random random(5);
    for (const NamedHull& named : allHulls())
        for (int i = 0; i < 2; ++i) {
            SCOPED_TRACE(named.name);
            const Hull& hull = *named.hull;
            const Pose pose = inSeaway(hull, random);
            const double time = random.uniform(0, 9), size = momentOfAll(hull) / weightOfAll(hull);
            const HydrostaticResult result = evaluateReference(hull, pose, seaway(), at(time));
            const Vec3 direction = random.direction(), axis = random.direction();
            const double turn = 1e-2, step = turn * size;
            const double force = -slopeOf(
                [&](double s) {
                    const Pose moved{pose.position + s * direction, pose.orientation};
                    return evaluateReference(hull, moved, seaway(), at(time)).potentialEnergy;
                },
                step);
            const double torque = -slopeOf(
                [&](double angle) {
                    const Pose moved{pose.position, turnedBy(angle, axis) * pose.orientation};
                    return evaluateReference(hull, moved, seaway(), at(time)).potentialEnergy;
                },
                turn);
            // 1.5 times the error of the energies over the step. What the difference itself leaves out, and
            // jumps of the force's second derivative where an edge passes the surface, are a tenth of it and
            // less.
            const double tolerance = promised + 1.5 * promised / turn;
            EXPECT_NEAR(result.forceWorld.dot(direction), force, tolerance * weightOfAll(hull));
            EXPECT_NEAR(result.torqueAboutCom.dot(axis), torque, tolerance * momentOfAll(hull));
        }
}

TEST(ReferenceInWaves, ATighterToleranceChangesNoMoreThanTheLooserOneAllowed) {
    Random random(6);
    for (PressureModel model : {PressureModel::hydrostatic, PressureModel::waveDynamic})
        for (const NamedHull& named : allHulls()) {
            SCOPED_TRACE(named.name);
            const Hull& hull = *named.hull;
            const Pose pose = inSeaway(hull, random);
            const HydrostaticQuery query = at(3, model);
            const auto within = [&](const ReferenceTolerance& tolerance) {
                WaterAroundBody water(pose, seaway(), query);
                return toResult(integrateInWaves(hull, water, tolerance).wet, pose, seaway(), query,
                                water.upInBody());
            };
            const HydrostaticResult usual = evaluateReference(hull, pose, seaway(), query);
            const HydrostaticResult tight = within({1e-10, 1e-8}), loose = within({1e-5, 1e-3});
            EXPECT_LT(relativeDifference(usual, tight, hull, weightDensity), promised);
            EXPECT_LT(relativeAreaDifference(usual, tight, hull), promisedOfAreas);
            EXPECT_LT(relativeDifference(loose, tight, hull, weightDensity), 1e-5);
            EXPECT_LT(relativeAreaDifference(loose, tight, hull), 1e-3);
            EXPECT_LE(usual.forceErrorBound, promised * weightOfAll(hull));
            EXPECT_GT(usual.waterSamples, 0);
        }
}

TEST(ReferenceInWaves, SplittingFacesChangesNothing) {
    Random random(7);
    for (const auto& [name, hull] : polyhedra()) {
        SCOPED_TRACE(name);
        const auto split = hullOf(quartered(hull->mesh));
        const Pose pose = inSeaway(*hull, random);
        const HydrostaticResult a = evaluateReference(*hull, pose, seaway(), at(1));
        const HydrostaticResult b = evaluateReference(*split, pose, seaway(), at(1));
        EXPECT_LT(relativeDifference(a, b, *hull, weightDensity), 2 * promised);
        EXPECT_LT(relativeAreaDifference(a, b, *hull), 2 * promisedOfAreas);
    }
}

TEST(ReferenceInWaves, HowTheMeshLiesInTheBodyAndWhichWayIsUpChangeNothing) {
    Random random(8);
    const std::vector<SineWave> waves{{0.1, {0.6, 0.4}, 2.5, 1}, {0.05, {-1.1, 0.9}, 3.7, 2}};
    const SineWater water(waves), yUp(waves, WaterFrame::yUp({3, -4, 5}));
    const Eigen::Quaterniond worldFromFrame(yUp.frame().worldFromFrame());
    const Vec3 origin = yUp.frame().originWorld();
    for (const auto& [name, hull] : polyhedra()) {
        SCOPED_TRACE(name);
        const Eigen::Quaterniond inBody = random.orientation();
        const auto turnedHull = hullOf(moved(hull->mesh, {Vec3::Zero(), inBody}));
        const Pose pose = inSeaway(*hull, random);
        const Pose there{origin + worldFromFrame * pose.position,
                         worldFromFrame * pose.orientation * inBody.inverse()};
        const HydrostaticResult a = evaluateReference(*hull, pose, water, at(1));
        const HydrostaticResult b = evaluateReference(*turnedHull, there, yUp, at(1));
        EXPECT_TRUE(isNear(worldFromFrame * a.forceWorld, b.forceWorld, 2 * promised * weightOfAll(*hull)));
        EXPECT_TRUE(
            isNear(worldFromFrame * a.torqueAboutCom, b.torqueAboutCom, 2 * promised * momentOfAll(*hull)));
        EXPECT_NEAR(a.potentialEnergy, b.potentialEnergy, 2 * promised * momentOfAll(*hull));
    }
}

TEST(ReferenceInWaves, WavesOnlyWhereTheyReach) {
    const auto hull = hullOf(boxMesh({1, 1, 1}));
    EXPECT_EQ(evaluateReference(*hull, atHeight(2), seaway(), at(0)).submergedVolume, 0);
    const HydrostaticResult deep =
        evaluateReference(*hull, atHeight(-20), seaway(), at(0, PressureModel::waveDynamic));
    // At 19.5 m the longest of the waves is down to exp(-0.316 * 19.5) = 2e-3 of its 0.1 m.
    EXPECT_TRUE(isNear(deep.forceWorld, weightOfAll(*hull) * Vec3::UnitZ(), 1e-3 * weightOfAll(*hull)));
    EXPECT_NEAR(deep.submergedVolume, 1, promised);
}

}  // namespace
}  // namespace bullet_buoyancy::test
