#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/current.h"
#include "bullet_buoyancy/water/function_water.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "bullet_buoyancy/water/height_grid.h"
#include "bullet_buoyancy/water/sea_state.h"
#include "bullet_buoyancy/water/water_sum.h"
#include "support/compare_results.h"
#include "support/known_solids.h"
#include "support/near.h"
#include "support/quadratic_water.h"
#include "support/random_sea.h"
#include "support/random_waves.h"
#include "support/still_water.h"

namespace bullet_buoyancy::test {
namespace {

double weightOfAll(const Hull& hull) {
    return weightDensity * hull.moments.volume;
}

/// That times the hull's size, seen from the centre of mass.
double momentOfAll(const Hull& hull) {
    return weightOfAll(hull) * (hull.bounds.radius + hull.bounds.centre.norm());
}

HydrostaticQuery at(double time, double tolerance, PressureModel model = PressureModel::hydrostatic) {
    HydrostaticQuery query;
    query.time = time;
    query.tolerance = tolerance;
    query.pressure = model;
    return query;
}

/// One wave in deep water, with a crest at the origin at time 0 if `phase` is 0.
WaveComponent waveOf(double amplitude, double wavenumber, double direction = 0, double phase = 0) {
    return {amplitude, wavenumber, direction, frequencyOfWavenumber(wavenumber), phase};
}

AiryWaves airyWaves(std::vector<WaveComponent> components, const WaterFrame& frame = WaterFrame::zUp()) {
    AiryWavesDef def;
    def.components = std::move(components);
    return AiryWaves(frame, def);
}

std::vector<NamedHull> allHulls() {
    std::vector<NamedHull> hulls = polyhedra();
    for (const NamedHull& solid : smoothSolids())
        hulls.push_back(solid);
    return hulls;
}

/// A box of draft T and twice that height, about the middle of its waterline.
struct FloatingBox {
    double along, across, draft;  ///< of the waves' direction, m
};

/// Per unit of amplitude and rho g: heave, surge along the waves, and moment about the horizontal axis to the
/// left of them, whose cosine, sine and sine of the frequency times time they go with.
struct FroudeKrylov {
    double heave, surge, pitch;

    FroudeKrylov(const FloatingBox& box, double k) {
        const double length = box.along, beam = box.across, decayed = std::exp(-k * box.draft);
        const double sine = std::sin(k * length / 2), cosine = std::cos(k * length / 2);
        const double alongBottom = 2 * (sine / (k * k) - length / 2 * cosine / k);
        const double downEnds = (1 - decayed * (1 + k * box.draft)) / (k * k);
        heave = beam * 2 * sine / k * decayed;
        surge = -beam * 2 * sine * (1 - decayed) / k;
        pitch = -beam * (decayed * alongBottom - 2 * sine * downEnds);
    }
};

/// Half of the difference between a wave and its opposite, over amplitude and rho g: what is of even order in
/// the waves cancels, still water with it.
struct Excitation {
    double heave, surge, pitch;

    Excitation(const FloatingBox& box, const WaveComponent& wave, double time) {
        const Vec3 ahead(std::cos(wave.direction), std::sin(wave.direction), 0);
        // The wave is beam on where it travels along y: then that is where the length along the waves lies.
        const bool beamOn = std::abs(ahead.y()) > 0.5;
        const double x = beamOn ? box.across : box.along, y = beamOn ? box.along : box.across;
        const auto hull = hullOf(boxMesh({x, y, 2 * box.draft}));
        WaveComponent opposite = wave;
        opposite.phase += pi;
        const HydrostaticQuery query = at(time, 1e-8, PressureModel::waveDynamic);
        const HydrostaticResult up = evaluateExact(*hull, Pose(), airyWaves({wave}), query);
        const HydrostaticResult down = evaluateExact(*hull, Pose(), airyWaves({opposite}), query);
        const double unit = 2 * wave.amplitude * weightDensity;
        const Vec3 force = (up.forceWorld - down.forceWorld) / unit;
        heave = force.z();
        surge = force.dot(ahead);
        pitch = (up.torqueAboutCom - down.torqueAboutCom).dot(Vec3::UnitZ().cross(ahead)) / unit;
    }
};

void expectFroudeKrylov(double direction, const FloatingBox& box) {
    const double length = std::max(box.along, box.across);
    for (double wavesInLength : {5.0, 10.0, 20.0, 40.0}) {
        SCOPED_TRACE(wavesInLength);
        const double k = 2 * pi / (wavesInLength * length);
        const FroudeKrylov expected(box, k);
        // The surface wanders by 0.02 of the draft: third order leaves the square of that, 4e-4.
        const WaveComponent wave = waveOf(0.02 * box.draft, k, direction);
        for (int i = 0; i < 8; ++i) {
            const double phase = 2 * pi * i / 8 + 0.1, time = phase / wave.frequency;
            const Excitation measured(box, wave, time);
            EXPECT_NEAR(measured.heave, expected.heave * std::cos(phase), 1e-3 * std::abs(expected.heave));
            EXPECT_NEAR(measured.surge, expected.surge * std::sin(phase), 1e-3 * std::abs(expected.surge));
            EXPECT_NEAR(measured.pitch, expected.pitch * std::sin(phase), 1e-3 * std::abs(expected.pitch));
        }
    }
}

TEST(KnownWaves, HeaveSurgeAndPitchOfABoxAheadAreThoseOfFroudeAndKrylov) {
    expectFroudeKrylov(0, {2, 0.8, 0.6});
}

TEST(KnownWaves, HeaveSwayAndRollOfABoxOnTheBeamAreThoseOfFroudeAndKrylov) {
    expectFroudeKrylov(pi / 2, {0.8, 2, 0.6});
}

/// -grad of the depth is (-slope, 1): its mean over a displacement is that at the centre of buoyancy, but for
/// third derivatives of the elevation times half the mean square of the distance from there.
TEST(KnownWaves, ASmallBodyIsPushedSquareToTheSurface) {
    const AiryWaves water = airyWaves({waveOf(0.4, 0.6), waveOf(0.1, 1.1, 1.2, 0.7)});
    Random random(31);
    for (double size : {0.2, 0.05})
        for (int i = 0; i < 50; ++i) {
            const auto hull = hullOf(boxMesh({size, 0.8 * size, 0.6 * size}));
            const Vec2 place = random.inCube(50).head<2>();
            Eigen::ArrayX3d surface(1, 3);
            water.sampleSurface(place.transpose().array(), 3, surface);
            const double height = surface(0, 0) - random.uniform(-0.2, 2) * size;
            const Pose pose{{place.x(), place.y(), height}, random.orientation()};
            const HydrostaticResult result = evaluateExact(*hull, pose, water, at(3, 1e-7));
            if (result.submergedVolume < 0.05 * hull->moments.volume) continue;
            const Vec3 centre = pose.position + result.centreOfBuoyancyFromCom;
            water.sampleSurface(centre.head<2>().transpose().array(), 3, surface);
            const Vec2 slope(surface(0, 1), surface(0, 2));
            const Vec2 leaning = result.forceWorld.head<2>() / result.forceWorld.z();
            const double radius2 = hull->bounds.radius * hull->bounds.radius;
            const double tolerance = water.bounds().curvatureChange * radius2 / 2 +
                                     3 * result.forceErrorBound / result.forceWorld.z();
            EXPECT_TRUE(isNear(leaning, -slope, tolerance));
        }
}

using Corners = std::array<Vec3, 3>;

/// Calls `visit` with the parts of a mesh, in the world, over which a depth that is linear is above zero.
template <typename Depth, typename Visit>
void visitWet(const TriangleMesh& mesh, const Pose& pose, const Depth& depth, const Visit& visit) {
    for (const Triangle& t : mesh.triangles) {
        std::vector<Vec3> wet;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = pose.position + pose.orientation * mesh.vertices[t[i]];
            const Vec3 b = pose.position + pose.orientation * mesh.vertices[t[(i + 1) % 3]];
            const double da = depth(a), db = depth(b);
            if (da > 0) wet.push_back(a);
            if ((da > 0) != (db > 0)) wet.push_back(a + da / (da - db) * (b - a));
        }
        for (std::size_t i = 2; i < wet.size(); ++i)
            visit(Corners{wet[0], wet[i - 1], wet[i]});
    }
}

/// Force and torque about a point of a pressure that is linear over triangles, from that at their corners,
/// Pa: exact.
struct LinearPressure {
    Vec3 about;
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();

    void add(const Corners& x, const std::array<double, 3>& pressure) {
        const Vec3 area = (x[1] - x[0]).cross(x[2] - x[0]) / 2;
        const double sum = pressure[0] + pressure[1] + pressure[2];
        Vec3 moment = sum * (x[0] + x[1] + x[2] - 3 * about);
        for (std::size_t i = 0; i < 3; ++i)
            moment += pressure[i] * (x[i] - about);
        force -= sum / 3 * area;
        torque -= moment.cross(area) / 12;
    }
};

TEST(KnownWaves, WithoutATolerancePressureIsLinearBetweenTheCorners) {
    Random random(32);
    GerstnerWavesDef def;
    def.components = randomWaves(6, 0.4, random);
    const GerstnerWaves water(WaterFrame::zUp(), def);
    const auto hull = hullOf(tessellate(Sphere{{0.1, -0.2, 0.05}, 0.6}, 3));
    for (int i = 0; i < 20; ++i) {
        const Pose pose{
            Vec3(random.uniform(-50, 50), random.uniform(-50, 50), -1.5 - water.bounds().elevation),
            random.orientation()};
        const double time = random.uniform(0, 100);
        LinearPressure sum{pose.position};
        visitWet(
            hull->mesh, pose, [](const Vec3&) { return 1.0; },
            [&](const Corners& x) {
                std::array<double, 3> pressure;
                for (std::size_t k = 0; k < 3; ++k) {
                    Eigen::ArrayX3d surface(1, 3);
                    water.sampleSurface(x[k].head<2>().transpose().array(), time, surface);
                    pressure[k] = weightDensity * (surface(0, 0) - x[k].z());
                }
                sum.add(x, pressure);
            });
        const HydrostaticResult result = evaluateExact(*hull, pose, water, at(time, 0));
        EXPECT_TRUE(isNear(result.forceWorld, sum.force, 1e-10 * weightOfAll(*hull)));
        EXPECT_TRUE(isNear(result.torqueAboutCom, sum.torque, 1e-10 * momentOfAll(*hull)));
    }
}

/// Under a tilted plane pressure is linear, and the truth is that of flat water under a gravity that is
/// stronger and along the plane's normal.
TEST(KnownWaves, TheMeanHeightOfTheWaterOverATriangleWillNotDo) {
    const Vec2 slope(0.1, 0);
    const QuadraticWater water(0, slope);
    const FlatWater asFlat(WaterFrame::fromUp(Vec3::Zero(), {-slope.x(), -slope.y(), 1}));
    const auto depth = [&](const Vec3& x) { return slope.dot(x.head<2>()) - x.z(); };
    HydrostaticQuery stronger;
    stronger.gravity *= std::sqrt(1 + slope.squaredNorm());
    const auto hull = hullOf(boxMesh({4, 2, 0.5}));
    // Level, and heeled against the slope, where the torque is the largest and so the share the smallest.
    for (double heel : {0.0, 0.2}) {
        const Pose pose = atHeight(0, turnedBy(heel, Vec3::UnitY()));
        const Vec3 truth = evaluateExact(*hull, pose, asFlat, stronger).torqueAboutCom;
        LinearPressure byMean{pose.position};
        visitWet(hull->mesh, pose, depth, [&](const Corners& x) {
            const double mean = slope.dot((x[0] + x[1] + x[2]).head<2>()) / 3;
            byMean.add(x, {weightDensity * (mean - x[0].z()), weightDensity * (mean - x[1].z()),
                           weightDensity * (mean - x[2].z())});
        });
        EXPECT_GT((byMean.torque - truth).norm(), 0.1 * truth.norm());
        for (double tolerance : {1e-3, 0.0})
            EXPECT_TRUE(isNear(evaluateExact(*hull, pose, water, at(0, tolerance)).torqueAboutCom, truth,
                               1e-10 * truth.norm()));
    }
}

/// Rounding may also tip a decision of where to quarter a triangle, and then shift the result by a share of
/// the tolerance: it does not in the cases here.
void expectSame(const HydrostaticResult& a, const HydrostaticResult& b, const Hull& hull, double rounding) {
    EXPECT_LE(relativeDifference(a, b, hull, weightDensity), rounding);
    EXPECT_EQ(a.waterSamples, b.waterSamples);
    EXPECT_NEAR(a.forceErrorBound, b.forceErrorBound, rounding * weightOfAll(hull));
}

/// A hull at or near the surface of a wave of 12 m.
struct InOneWave {
    WaveComponent wave = waveOf(0.3, 2 * pi / 12, 0.5);
    Vec3 ahead{std::cos(wave.direction), std::sin(wave.direction), 0};
    double time = 2.5;  // s

    /// Phases of up to two turns are rounded by twelve times as much as numbers of about 1; integrals have
    /// hundreds of terms.
    static constexpr double rounding = 12 * 300 * epsilon;
};

TEST(KnownWaves, AWaveLengthOnOrAPeriodLaterNothingHasChanged) {
    const InOneWave in;
    Random random(33);
    for (PressureModel model : {PressureModel::hydrostatic, PressureModel::waveDynamic})
        for (const NamedHull& named : allHulls()) {
            SCOPED_TRACE(named.name);
            const Pose pose = atSurface(*named.hull, random);
            const AiryWaves water = airyWaves({in.wave});
            const auto moved = [&](double distance, double later) {
                const Pose there{pose.position + distance * in.ahead, pose.orientation};
                return evaluateExact(*named.hull, there, water, at(in.time + later, 1e-3, model));
            };
            const double length = 2 * pi / in.wave.wavenumber, period = 2 * pi / in.wave.frequency;
            const HydrostaticResult here = moved(0, 0);
            expectSame(here, moved(length, 0), *named.hull, in.rounding);
            expectSame(here, moved(0, period), *named.hull, in.rounding);
            // 12 km away
            expectSame(here, moved(1000 * length, 0), *named.hull, 1000 * in.rounding);
            expectSame(here, moved(0.3 * length, 0.3 * period), *named.hull, in.rounding);
        }
}

TEST(KnownWaves, TheirFrameAndHowFarItIsChangeNothing) {
    Random random(34);
    GerstnerWavesDef gerstner;
    gerstner.components = randomWaves(6, 0.3, random);
    AiryWavesDef airy;
    airy.components = gerstner.components;
    const WaterFrame frames[] = {WaterFrame::yUp({3, -4, 5}), WaterFrame::fromUp({0, 1, 2}, {1, -2, 0.5}),
                                 WaterFrame::zUp({10e3, -10e3, 100})};
    for (const WaterFrame& frame : frames) {
        const Eigen::Quaterniond turn(frame.worldFromFrame());
        const GerstnerWaves trochoids(WaterFrame::zUp(), gerstner), trochoidsThere(frame, gerstner);
        const AiryWaves sines(WaterFrame::zUp(), airy), sinesThere(frame, airy);
        const auto check = [&](const WaterField& water, const WaterField& there, const NamedHull& named,
                               double rounding) {
            SCOPED_TRACE(named.name);
            const Pose pose = atSurface(*named.hull, random);
            const HydrostaticResult a = evaluateExact(*named.hull, pose, water, at(1, 1e-3));
            HydrostaticResult b = evaluateExact(
                *named.hull, {frame.originWorld() + turn * pose.position, turn * pose.orientation}, there,
                at(1, 1e-3));
            for (Vec3* vector : {&b.forceWorld, &b.torqueAboutCom, &b.centreOfBuoyancyFromCom})
                *vector = turn.conjugate() * *vector;
            expectSame(a, b, *named.hull, rounding);
        };
        for (const NamedHull& named : allHulls()) {
            // Places are rounded by 2e-12 m out there, and the thinnest hull is 3 cm; heights of trochoids
            // are right to 1e-9 m.
            check(sines, sinesThere, named, 1e-10);
            check(trochoids, trochoidsThere, named, 1e-7);
        }
    }
}

TEST(KnownWaves, AFinerMeshAsksTheWaterNoMoreOften) {
    Random random(35);
    const auto coarse = hullOf(tessellate(Sphere{Vec3::Zero(), 0.5}, 2)),
               fine = hullOf(tessellate(Sphere{Vec3::Zero(), 0.5}, 5));
    ASSERT_EQ(coarse->mesh.triangles.size(), 320u);
    ASSERT_EQ(fine->mesh.triangles.size(), 20480u);
    int few = 0, many = 0;
    for (std::size_t i = 0; i < 90; ++i) {
        const RandomSea sea = randomSea(i, random);
        const Pose pose = poseAcross(*sea.water, *coarse, 7, random);
        few += evaluateExact(*coarse, pose, *sea.water, at(7, 1e-3)).waterSamples;
        many += evaluateExact(*fine, pose, *sea.water, at(7, 1e-3)).waterSamples;
    }
    EXPECT_LE(many, 1.5 * few);
}

/// Over a square of half width h the elevation c (x^2 + y^2) / 2 ranges from 0 to c h^2 and has a mean of
/// c h^2 / 3: a plane in the middle of its range is off by c h^2 / 2 at most, c h^2 / 6 on the mean.
TEST(KnownWaves, AnUprightBoxInABowlOfWaterIsOffByAThirdOfItsBound) {
    const double curvature = 0.02, halfWidth = 0.5, area = 1;
    const QuadraticWater water(0.1, Vec2::Zero(), Vec2::Constant(curvature));
    const auto hull = hullOf(boxMesh({1, 1, 1}));
    const HydrostaticResult result = evaluateExact(*hull, Pose(), water, at(0, 1e-2));
    const double square = curvature * halfWidth * halfWidth;
    const double lift = water.density() * standardGravity * area;
    EXPECT_TRUE(isNear(result.forceWorld, lift * (0.6 + square / 2) * Vec3::UnitZ(), 1e-12 * lift));
    // The slopes in the bowl add a force sideways on what is misplaced: 0.02 of it; round hulls a hundredth.
    EXPECT_NEAR(result.forceErrorBound, lift * square / 2, 0.011 * lift * square / 2);
    // Held to less than that bound, it is right.
    const HydrostaticResult right = evaluateExact(*hull, Pose(), water, at(0, 1e-4));
    EXPECT_NEAR(right.forceWorld.z(), lift * (0.6 + square / 3), 1e-12 * lift);
}

/// The pressure of a displacement in a bowl pushes sideways as the slope at its centre says, c times the
/// offset from the bowl's middle.
TEST(KnownWaves, ABoxIsPushedOffTheSideOfABowlOfWater) {
    const double curvature = 0.01;
    const QuadraticWater water(0, Vec2::Zero(), Vec2::Constant(curvature));
    const auto hull = hullOf(boxMesh({1, 1, 1}, {0.3, 0, 0}));
    const Pose pose{Vec3(2, 0, 0.02), Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};
    const HydrostaticResult result = evaluateExact(*hull, pose, water, at(0, 1e-2));
    const Vec3 centre = pose.position + result.centreOfBuoyancyFromCom;
    EXPECT_EQ(result.waterSamples, 1);
    EXPECT_NEAR(result.forceWorld.x(),
                -water.density() * standardGravity * result.submergedVolume * curvature * centre.x(),
                1e-9 * water.density() * standardGravity);
}

TEST(KnownWaves, ADryBodyTakesNoSampleWhateverTheSea) {
    Random random(36);
    for (std::size_t i = 0; i < 45; ++i) {
        const RandomSea sea = randomSea(i, random);
        for (const NamedHull& named : allHulls()) {
            SCOPED_TRACE(named.name + " in " + sea.kind);
            Pose pose = poseAcross(*sea.water, *named.hull, 7, random);
            pose.position += 2 * (sea.water->bounds().elevation + named.hull->bounds.radius) *
                             sea.water->frame().upWorld();
            const HydrostaticResult dry = evaluateExact(*named.hull, pose, *sea.water, at(7, 1e-3));
            EXPECT_EQ(dry.waterSamples, 0);
            EXPECT_EQ(dry.forceWorld, Vec3::Zero());
            EXPECT_EQ(dry.forceErrorBound, 0);
        }
    }
}

/// In waves so long for it that the water to second order about its middle will do.
TEST(KnownWaves, ADeepBodyTakesOneSample) {
    const std::vector<WaveComponent> waves{waveOf(0.5, 2 * pi / 100, 0.3), waveOf(0.2, 2 * pi / 60, -1, 2)};
    const AiryWaves airy = airyWaves(waves);
    GerstnerWavesDef def;
    def.components = waves;
    const GerstnerWaves gerstner(WaterFrame::zUp(), def);
    Random random(40);
    for (PressureModel model : {PressureModel::hydrostatic, PressureModel::waveDynamic})
        for (const WaterField* water : std::initializer_list<const WaterField*>{&airy, &gerstner})
            for (const NamedHull& named : allHulls()) {
                SCOPED_TRACE(named.name);
                Pose pose = poseAcross(*water, *named.hull, 7, random);
                pose.position.z() -= 2 * (water->bounds().elevation + named.hull->bounds.radius);
                const HydrostaticResult deep = evaluateExact(*named.hull, pose, *water, at(7, 1e-3, model));
                EXPECT_EQ(deep.waterSamples, 1);
                const HydrostaticResult truth =
                    evaluateReference(*named.hull, pose, *water, at(7, 1e-3, model));
                // The force wants the third derivative of the waves, 3e-4 1/m^2 and less, times half the mean
                // square of the distance from the middle, 0.4 m^2 for the plank; the torque the fourth.
                EXPECT_TRUE(isNear(deep.forceWorld, truth.forceWorld, 1e-4 * weightOfAll(*named.hull)));
                EXPECT_TRUE(
                    isNear(deep.torqueAboutCom, truth.torqueAboutCom, 1e-5 * momentOfAll(*named.hull)));
                EXPECT_NEAR(deep.submergedVolume, truth.submergedVolume, 1e-8 * named.hull->moments.volume);
            }
}

TEST(KnownWaves, WaterThatHappensToBeFlatCostsWhatFlatWaterDoes) {
    const WaterFrame frame = WaterFrame::zUp();
    const FlatWater flat(frame);
    const AiryWaves airy = airyWaves({}), noHeight = airyWaves({waveOf(0, 1)});
    const GerstnerWaves gerstner(frame, {});
    const Current current(frame, CurrentDef{Vec3(1, 0.5, 0)});
    HeightGridDef gridDef;
    gridDef.nodesX = gridDef.nodesY = 8;
    const HeightGrid grid(frame, gridDef);
    FunctionWaterDef functionDef;
    functionDef.surface = [](double, double, double) { return Eigen::Array3d::Zero().eval(); };
    const FunctionWater function(frame, functionDef);
    const WaterSum sum({&airy, &current});
    Random random(37);
    for (const WaterField* water : std::initializer_list<const WaterField*>{&airy, &noHeight, &gerstner,
                                                                            &current, &grid, &function, &sum})
        for (const NamedHull& named : allHulls()) {
            SCOPED_TRACE(named.name);
            ASSERT_TRUE(water->bounds().isFlat());
            const Pose pose = atSurface(*named.hull, random);
            const HydrostaticResult result = evaluateExact(*named.hull, pose, *water, everything());
            const HydrostaticResult expected = evaluateExact(*named.hull, pose, flat, everything());
            EXPECT_EQ(result.waterSamples, 0);
            EXPECT_EQ(result.forceErrorBound, 0);
            EXPECT_EQ(relativeDifference(result, expected, *named.hull, weightDensity), 0);
        }
}

TEST(KnownWaves, VolumeCentreAndEnergyAreWithinAFewTolerances) {
    constexpr double tolerance = 1e-3;
    Random random(38);
    for (const NamedHull& named : polyhedra())
        for (std::size_t i = 0; i < 45; ++i) {
            const RandomSea sea = randomSea(i, random);
            SCOPED_TRACE(named.name + " in " + sea.kind);
            const Pose pose = poseAcross(*sea.water, *named.hull, 7, random);
            const HydrostaticResult result = evaluateExact(*named.hull, pose, *sea.water, at(7, tolerance));
            const HydrostaticResult truth = evaluateReference(*named.hull, pose, *sea.water, at(7, 0));
            EXPECT_LE(relativeDifference(result, truth, *named.hull, sea.water->density() * standardGravity),
                      tolerance);
        }
}

/// Central differences of fourth order.
template <typename Function>
double slopeOf(const Function& f, double step) {
    return (8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step);
}

TEST(KnownWaves, ForceAndTorqueOnMeshesAreTheSlopeOfThePotential) {
    const AiryWaves water = airyWaves({waveOf(0.3, 0.5, 0.3), waveOf(0.1, 0.9, -0.8, 1)});
    Random random(39);
    for (const NamedHull& named : polyhedra())
        for (int i = 0; i < 5; ++i) {
            SCOPED_TRACE(named.name);
            const Hull& hull = *named.hull;
            const Pose pose = poseAcross(water, hull, 2, random);
            const HydrostaticQuery query = at(2, 1e-6);
            const HydrostaticResult result = evaluateExact(hull, pose, water, query);
            const Vec3 direction = random.direction(), axis = random.direction();
            const double turn = 1e-2, size = momentOfAll(hull) / weightOfAll(hull);
            const auto energy = [&](const Vec3& move, double angle) {
                const Pose moved{pose.position + move, turnedBy(angle, axis) * pose.orientation};
                return evaluateExact(hull, moved, water, query).potentialEnergy;
            };
            const double force = -slopeOf([&](double s) { return energy(s * direction, 0); }, turn * size);
            const double torque = -slopeOf([&](double angle) { return energy(Vec3::Zero(), angle); }, turn);
            // 1.5 times the error of the energies over the step; thrice that for what the difference leaves
            // out and for jumps of the force's second derivative where an edge passes the surface.
            const double tolerance = 3 * 1.5 * query.tolerance / turn;
            EXPECT_NEAR(result.forceWorld.dot(direction), force, tolerance * weightOfAll(hull));
            EXPECT_NEAR(result.torqueAboutCom.dot(axis), torque, tolerance * momentOfAll(hull));
        }
}

}  // namespace
}  // namespace bullet_buoyancy::test
