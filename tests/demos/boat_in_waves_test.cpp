#include "scenes/boat_in_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/water/dispersion.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/spectrum.h"
#include "scenes/wigley_hull.h"
#include "support/known_solids.h"

namespace bullet_buoyancy::scenes {
namespace {

using Complex = std::complex<double>;

HydrostaticResult atDesignDraft(const WigleyDef& def) {
    HydrostaticQuery query;
    query.waterplane = true;
    return evaluateExact(*makeHull(wigleyMesh(def)).hull, Pose(), FlatWater(WaterFrame::zUp()), query);
}

/// Chords of n stations and m waterlines take 1/n^2 and 1/(4 m^2) of the parabolas' areas away, and the
/// diagonals of the twisted panels bulge out by 3/(8 n m) of the volume.
TEST(WigleyHull, VolumeAndWaterplaneAreThoseOfTheClosedForm) {
    for (const auto& [n, m] : {std::pair(8, 3), std::pair(24, 8), std::pair(80, 40)}) {
        WigleyDef def;
        def.stations = n;
        def.waterlines = m;
        const double box = def.length * def.beam;
        const HydrostaticResult result = atDesignDraft(def);
        const double chords = (1 - 1.0 / (n * n)) * (1 - 0.25 / (m * m)) + 0.375 / (n * m);
        EXPECT_NEAR(result.submergedVolume / (4.0 / 9 * box * def.draft), chords, 1e-12);
        EXPECT_NEAR(result.waterplane.area / (2.0 / 3 * box), 1 - 1.0 / (n * n), 1e-12);
        EXPECT_NEAR(result.centreOfBuoyancyFromCom.x(), 0, 1e-12);
        EXPECT_NEAR(result.centreOfBuoyancyFromCom.y(), 0, 1e-12);
        // What the chords move lies within the draft.
        EXPECT_NEAR(result.centreOfBuoyancyFromCom.z(), -0.375 * def.draft,
                    (1 / double(n * n) + 0.25 / (m * m) + 0.375 / (n * m)) * def.draft);
    }
}

TEST(WigleyHull, IsClosedAndClean) {
    const HullResult result = makeHull(wigleyMesh());
    ASSERT_TRUE(result.hull);
    EXPECT_EQ(result.status.describe(), "ok");
    EXPECT_TRUE(result.hull->meshIsClosed);
}

/// Coarse, for the sake of the sanitizers' patience.
constexpr int stations = 12, waterlines = 4;

Boat wigleyBoat() {
    WigleyDef def;
    def.stations = stations;
    def.waterlines = waterlines;
    const TriangleMesh mesh = wigleyMesh(def);
    LadingDef lading;
    lading.displacement = displacementBelowOrigin(mesh);
    return makeBoat(mesh, lading);
}

/// Five metres long and half under water.
Boat barge() {
    LadingDef lading;
    lading.displacement = 5 * 2 * 0.5;
    return makeBoat(test::boxMesh({5, 2, 1}), lading);
}

/// BM of a Wigley hull is 3/35 B^2 / T in roll and 3/40 L^2 / T in pitch; chords are some 1/n^2 off.
TEST(Boat, FloatsWhereItWasDesignedTo) {
    const Boat boat = wigleyBoat();
    ASSERT_TRUE(boat.hull);
    const double chords = 4.0 / (stations * stations);
    EXPECT_NEAR(boat.draft, 1, 1e-9);
    EXPECT_NEAR(boat.metacentricHeight, 0.25, 1e-9);
    const double keelToMetacentre = boat.draft + boat.heightAtRest + boat.metacentricHeight;
    EXPECT_NEAR(keelToMetacentre, 0.625 + 3.0 / 35 * 2.5 * 2.5, 2 * chords);
    const double longer = boat.longitudinalMetacentric - boat.metacentricHeight;
    EXPECT_NEAR(longer / (0.075 * 100 - 3.0 / 35 * 2.5 * 2.5), 1, 2 * chords);
    EXPECT_NEAR(boat.heavePeriod() / (2 * pi * std::sqrt(2.0 / 3 / standardGravity)), 1, chords);
}

SeaDef regularSea(double height, double period, double heading = pi) {
    SeaDef sea;
    sea.kind = SeaKind::airy;
    sea.height = height;
    sea.period = period;
    sea.direction = heading;
    return sea;
}

double periodOfLength(double length) {
    return 2 * pi / frequencyOfWavenumber(2 * pi / length);
}

/// What a record has at one frequency: amplitude and phase of value cos(phase - 2 pi t / period).
Complex harmonic(const Voyage& voyage, double VoyageSample::*quantity, double period) {
    Complex sum = 0;
    for (const VoyageSample& sample : voyage.samples)
        sum += sample.*quantity * std::polar(1.0, 2 * pi * sample.time / period);
    return 2.0 * sum / double(voyage.samples.size());
}

/// Whole periods, after as many as it takes for the start to be forgotten.
VoyageDef wholePeriods(double period, int periods, PressureModel pressure) {
    VoyageDef def;
    def.settling = 4 * period;
    def.step = period / std::ceil(30 * period);
    def.duration = periods * period;
    def.buoyancy.pressure = pressure;
    def.mooringPeriod = std::numeric_limits<double>::infinity();
    return def;
}

/// A flat bottom of length l at a depth T feels the wave's pressure at its own depth, and its mean along l:
/// m z'' = rho g A (sinc(k l / 2) e^(-k T) eta - z) - c m (z' - w), with the water's velocity w at the middle
/// of the draft. Hydrostatic pressure does not decay.
Complex heaveOfBarge(double k, bool decays, double dragRate) {
    const double draft = 0.5, half = k * 5 / 2, omega = frequencyOfWavenumber(k);
    const double own = standardGravity / draft;
    const Complex i(0, 1);
    const double push = std::sin(half) / half * (decays ? std::exp(-k * draft) : 1);
    const Complex orbit = dragRate * -i * omega * std::exp(-k * draft / 2);
    return (own * push + orbit) / (own - omega * omega - i * omega * dragRate);
}

/// In waves of 20 lengths: what is left is of the second order of the wave's slope (3 %) and the step's.
TEST(Barge, HeavesAsItsEquationOfMotionSays) {
    const double wavelength = 100, k = 2 * pi / wavelength, period = periodOfLength(wavelength);
    const Boat boat = barge();
    for (PressureModel pressure : {PressureModel::hydrostatic, PressureModel::waveDynamic}) {
        Sea sea(regularSea(1, period));
        const VoyageDef def = wholePeriods(period, 5, pressure);
        const Voyage voyage = sail(boat, sea, def);
        ASSERT_EQ(voyage.mishap, Mishap::none);
        const bool decays = pressure == PressureModel::waveDynamic;
        const Complex expected = heaveOfBarge(k, decays, def.linearDrag / 2);
        // The phase is that at the place to which the boat has drifted.
        const double drift = meanOf(series(voyage, &VoyageSample::surge));
        const Complex found = std::polar(1.0, k * drift) * harmonic(voyage, &VoyageSample::heave, period) /
                              harmonic(voyage, &VoyageSample::elevation, period);
        EXPECT_LT(std::abs(found - expected), 5e-3) << decays << ' ' << found << ' ' << expected;
        if (decays) {
            EXPECT_NEAR(std::abs(found), 1, 0.01);
        }
    }
}

/// Tens of times as long as the boat.
TEST(Boat, GoesWithLongWaves) {
    const double wavelength = 300, period = periodOfLength(wavelength), k = 2 * pi / wavelength;
    const Boat boat = wigleyBoat();
    Sea sea(regularSea(2, period));
    const Voyage voyage = sail(boat, sea, wholePeriods(period, 3, PressureModel::waveDynamic));
    ASSERT_EQ(voyage.mishap, Mishap::none);
    const Complex elevation = harmonic(voyage, &VoyageSample::elevation, period);
    EXPECT_NEAR(std::abs(harmonic(voyage, &VoyageSample::heave, period) / elevation), 1, 0.01);
    // The wave travels to -x: d eta/dx = -k d eta/d(-x), a quarter of a period before or after the crest.
    const Complex pitch = harmonic(voyage, &VoyageSample::pitch, period) / (k * elevation);
    EXPECT_NEAR(std::abs(pitch), 1, 0.03);
    EXPECT_NEAR(std::abs(pitch.imag()), 1, 0.03);
}

VoyageDef shortVoyage() {
    VoyageDef def;
    def.step = 1.0 / 30;
    def.settling = 5;
    def.duration = 25;
    def.buoyancy = {PressureModel::hydrostatic, 1e-2};
    return def;
}

TEST(Boat, DoesNotRollInAHeadSea) {
    const Boat boat = wigleyBoat();
    SeaDef def;
    def.components = 16;
    Sea sea(def);
    const Voyage voyage = sail(boat, sea, shortVoyage());
    ASSERT_EQ(voyage.mishap, Mishap::none);
    for (const VoyageSample& sample : voyage.samples)
        ASSERT_LT(std::abs(sample.roll), sizeof(btScalar) == 4 ? 1e-4 : 1e-9) << sample.time;
}

/// Symmetric under a wave from the other side.
TEST(Boat, RollsToEitherSideAlike) {
    const Boat boat = wigleyBoat();
    double roll[2];
    for (int side : {0, 1}) {
        Sea sea(regularSea(0.3, 5, side == 0 ? pi / 2 : -pi / 2));
        const Voyage voyage = sail(boat, sea, wholePeriods(5, 4, PressureModel::waveDynamic));
        roll[side] = std::abs(harmonic(voyage, &VoyageSample::roll, 5));
    }
    EXPECT_GT(roll[0], 0.01);
    EXPECT_NEAR(roll[0], roll[1], 1e-3 * roll[0]);
}

/// In every kind of sea, within half a length of its place, while the water goes one and a half.
TEST(Boat, StaysWhereItIsMoored) {
    const Boat boat = wigleyBoat();
    for (SeaKind kind : {SeaKind::airy, SeaKind::gerstner, SeaKind::jonswap, SeaKind::grid}) {
        SeaDef def;
        def.kind = kind;
        def.direction = 0.75 * pi;
        def.currentSpeed = 0.5;
        def.components = 8;
        Sea sea(def);
        ASSERT_TRUE(sea.status());
        const Voyage voyage = sail(boat, sea, shortVoyage());
        ASSERT_EQ(voyage.mishap, Mishap::none) << int(kind);
        for (const VoyageSample& sample : voyage.samples) {
            ASSERT_LT(std::hypot(sample.surge, sample.sway), 5) << int(kind) << ' ' << sample.time;
            ASSERT_LT(std::abs(sample.yaw), 0.5) << int(kind) << ' ' << sample.time;
        }
    }
}

TEST(Boat, DriftsWithTheCurrentWhenItIsFree) {
    const Boat boat = wigleyBoat();
    SeaDef def = regularSea(0, 6, 0);
    def.currentSpeed = 0.5;
    Sea sea(def);
    VoyageDef voyageDef;
    voyageDef.duration = 20;
    voyageDef.mooringPeriod = std::numeric_limits<double>::infinity();
    const Voyage voyage = sail(boat, sea, voyageDef);
    const double travelled = voyage.samples.back().surge - voyage.samples.front().surge;
    EXPECT_NEAR(travelled, 0.5 * (voyage.samples.back().time - voyage.samples.front().time), 1e-3);
}

TEST(Boat, ThatIsTooHeavyAtTheTopCapsizes) {
    const TriangleMesh mesh = wigleyMesh();
    LadingDef lading;
    lading.displacement = displacementBelowOrigin(mesh);
    lading.metacentricHeight = -0.3;
    lading.highestCentre = 2;
    Sea sea(regularSea(0.5, 5, pi / 2));
    VoyageDef def;
    def.duration = 60;
    EXPECT_EQ(sail(makeBoat(mesh, lading), sea, def).mishap, Mishap::capsized);
}

/// The grid is the same sea but for its resolution, four spacings or more a wave.
TEST(Sea, OnAGridIsThatOfItsWaves) {
    SeaDef def;
    def.kind = SeaKind::grid;
    def.direction = 2;
    def.components = 32;
    Sea sea(def);
    SeaStateDef same;
    same.spectrum.significantHeight = def.height;
    same.spectrum.peakPeriod = def.period;
    same.direction = def.direction;
    same.components = def.components;
    same.highestFrequency = 3;
    same.seed = def.seed;
    const AiryWaves waves(WaterFrame::zUp(), {makeSeaState(same).components});
    for (int i = 0; i < 100; ++i) {
        const Vec2 place(0.37 * i, -0.21 * i);
        sea.showAt(place, i);
        Eigen::ArrayX3d expected(1, 3), found(1, 3);
        waves.sampleSurface(Eigen::ArrayX2d(place.transpose().array()), i, expected);
        sea.water().sampleSurface(Eigen::ArrayX2d(place.transpose().array()), i, found);
        ASSERT_NEAR(found(0, 0), expected(0, 0), 0.03) << i;
        waves.sampleVelocity(Eigen::RowVector3d(place.x(), place.y(), expected(0, 0)).array(), i, expected);
        sea.water().sampleVelocity(Eigen::RowVector3d(place.x(), place.y(), found(0, 0)).array(), i, found);
        ASSERT_NEAR(found(0, 2), expected(0, 2), 0.06) << i;
    }
}

/// Lines of the sum that an hour tells apart leave less than chance would.
TEST(Sea, ProbeSeesTheHeightAndPeriodAskedFor) {
    for (std::uint64_t seed : {1u, 2u, 3u}) {
        SeaDef def;
        def.height = 2;
        def.seed = seed;
        Sea sea(def);
        const double step = 0.25;
        std::vector<double> elevations;
        for (double time = 0; time < 3600; time += step)
            elevations.push_back(sea.elevation(Vec2(3, -1), time));
        EXPECT_NEAR(4 * deviationOf(elevations) / def.height, 1, 0.03) << seed;
        const Spectrum spectrum = spectrumOf(elevations, step, 100);
        EXPECT_NEAR(1 / spectrum.peakFrequency() / def.period, 1, 0.1) << seed;
        EXPECT_NEAR(4 * std::sqrt(spectrum.variance()) / def.height, 1, 0.03) << seed;
    }
}

TEST(Sea, SpectrumAskedForHasTheHeightAskedFor) {
    const Sea sea{SeaDef()};
    double variance = 0;
    for (double f = 5e-4; f < 5; f += 1e-3)
        variance += 1e-3 * sea.spectralDensity(f);
    EXPECT_NEAR(4 * std::sqrt(variance), 1, 3e-3);
}

/// A sine's variance is half its amplitude squared; its line is as wide as the window's, and no wider.
TEST(Spectrum, OfASineIsItsVarianceAtItsFrequency) {
    const double step = 0.05, frequency = 0.2137, amplitude = 1.7;
    std::vector<double> signal;
    for (int i = 0; i < 20000; ++i)
        signal.push_back(3 + amplitude * std::sin(2 * pi * frequency * i * step));
    const Spectrum spectrum = spectrumOf(signal, step, 100);
    EXPECT_NEAR(spectrum.peakFrequency(), frequency, spectrum.resolution / 10);
    EXPECT_NEAR(spectrum.variance() / (amplitude * amplitude / 2), 1, 1e-3);
    double near = 0;
    for (std::size_t i = 0; i < spectrum.density.size(); ++i)
        if (std::abs(spectrum.frequency(i) - frequency) < 3 * spectrum.resolution)
            near += spectrum.density[i] * spectrum.resolution;
    EXPECT_GT(near / spectrum.variance(), 0.999);
    EXPECT_NEAR(meanPeriod(signal, step), 1 / frequency, 1e-3);
}

/// Parseval: to the chance of an estimate from 2000 / 64 segments of independent numbers.
TEST(Spectrum, OfNoiseIsFlatAndHasItsVariance) {
    std::vector<double> signal;
    std::uint64_t state = 1;
    for (int i = 0; i < 64000; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        signal.push_back(double(state >> 11) * 0x1p-53 - 0.5);
    }
    const double step = 0.5;
    const Spectrum spectrum = spectrumOf(signal, step, 32);
    const double variance = deviationOf(signal) * deviationOf(signal);
    EXPECT_NEAR(spectrum.variance() / variance, 1, 0.03);  // the means of short segments are taken off
    for (std::size_t i = 3; i + 3 < spectrum.density.size(); ++i)
        EXPECT_NEAR(spectrum.density[i] / (2 * step * variance), 1, 0.15) << i;
}

TEST(Spectrum, OfTooShortARecordIsNone) {
    EXPECT_TRUE(spectrumOf({1, 2, 3}, 1, 10).density.empty());
    EXPECT_TRUE(std::isnan(meanPeriod({1, 2, 3}, 1)));
}

}  // namespace
}  // namespace bullet_buoyancy::scenes
