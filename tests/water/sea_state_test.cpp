#include "bullet_buoyancy/water/sea_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "support/near.h"
#include "water/field_checks.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Integral of frequency^power times the spectrum, over u = peak / frequency by the midpoint rule: the
/// integrand is smooth on either side of the peak and falls to nothing at both ends.
double moment(const WaveSpectrum& spectrum, int power) {
    double sum = 0;
    const double peak = spectrum.peakFrequency(), step = 1e-4;
    for (int i = 0; i < 30000; ++i) {
        const double u = (i + 0.5) * step, frequency = peak / u;
        sum += std::pow(frequency, power) * spectrum.density(frequency) * peak / (u * u) * step;
    }
    return sum;
}

/// Elevation at one place every half second for an hour.
std::vector<double> hourOf(const std::vector<WaveComponent>& components) {
    const AiryWaves water(WaterFrame::zUp(), {components});
    std::vector<double> heights;
    for (int i = 0; i < 7200; ++i)
        heights.push_back(surfaceAt(water, 37, -11, 0.5 * i)[0]);
    return heights;
}

double significantHeight(const std::vector<double>& heights) {
    double sum = 0;
    for (double height : heights)
        sum += height * height;
    return 4 * std::sqrt(sum / double(heights.size()));
}

SeaStateDef sea(double spreading, std::uint64_t seed) {
    SeaStateDef def;
    def.spectrum = {3, 8, 3.3};
    def.spreading = spreading;
    def.seed = seed;
    return def;
}

double sumOfSquares(const SeaState& state) {
    double sum = 0;
    for (const WaveComponent& wave : state.components)
        sum += wave.amplitude * wave.amplitude;
    return sum;
}

TEST(WaveSpectrum, HasThePublishedHeightAndPeriod) {
    // 4 sqrt(m0) / Hs and T02 / Tp by the definition, five and four digits.
    const double table[][3] = {
        {1, 1.00000, .7105}, {2, .99891, .7466}, {3.3, 1.00121, .7775}, {5, 1.00000, .8054}};
    for (const auto& [gamma, height, period] : table) {
        const WaveSpectrum spectrum{3, 8, gamma};
        EXPECT_NEAR(4 * std::sqrt(moment(spectrum, 0)) / 3, height, 1e-5) << gamma;
        // Published integrals end at some multiple of the peak's frequency, which leaves out a few 1e-4.
        EXPECT_NEAR(2 * pi * std::sqrt(moment(spectrum, 0) / moment(spectrum, 2)) / 8, period, 3e-4) << gamma;
    }
    // In closed form for gamma = 1: T02 / Tp = (1.25 pi)^(-1/4).
    const WaveSpectrum developed{3, 8, 1};
    EXPECT_NEAR(2 * pi * std::sqrt(moment(developed, 0) / moment(developed, 2)) / 8,
                std::pow(1.25 * pi, -0.25), 1e-6);
    const WaveSpectrum spectrum{3, 8, 3.3};
    EXPECT_NEAR(spectrum.density(spectrum.peakFrequency()), 2.225571, 1e-6);
    EXPECT_EQ(spectrum.density(0), 0);
    EXPECT_EQ(spectrum.density(-1), 0);
}

TEST(SeaState, HasExactlyTheEnergyAskedFor) {
    for (int components : {1, 5, 64, 300})
        for (double spreading : {infinity, 10.0}) {
            SeaStateDef def = sea(spreading, 1);
            def.components = components;
            const SeaState state = makeSeaState(def);
            EXPECT_EQ(state.components.size(), std::size_t(components));
            EXPECT_NEAR(4 * std::sqrt(sumOfSquares(state) / 2), 3, 1e-12);
        }
}

TEST(SeaState, HasTheSignificantHeightOverAnHour) {
    for (double spreading : {infinity, 10.0})
        for (std::uint64_t seed = 1; seed <= 8; ++seed)
            EXPECT_NEAR(significantHeight(hourOf(makeSeaState(sea(spreading, seed)).components)), 3, 0.09)
                << seed;
}

TEST(SeaState, IsTheSameForTheSameSeedOnly) {
    const SeaState a = makeSeaState(sea(10, 7)), b = makeSeaState(sea(10, 7)), c = makeSeaState(sea(10, 8));
    for (std::size_t i = 0; i < a.components.size(); ++i) {
        EXPECT_EQ(a.components[i].amplitude, b.components[i].amplitude);
        EXPECT_EQ(a.components[i].direction, b.components[i].direction);
        EXPECT_EQ(a.components[i].frequency, b.components[i].frequency);
        EXPECT_EQ(a.components[i].phase, b.components[i].phase);
        EXPECT_NE(a.components[i].phase, c.components[i].phase);
        EXPECT_NE(a.components[i].frequency, c.components[i].frequency);
    }
}

TEST(SeaState, HasItsPeakWhereAsked) {
    for (double period : {5.0, 8.0, 12.0}) {
        SeaStateDef def = sea(infinity, 3);
        def.spectrum.peakPeriod = period;
        const std::vector<double> heights = hourOf(makeSeaState(def).components);
        // Energy in bands as wide as a tenth of the peak's frequency, the record's own lines being 1 / hour.
        const double peak = 2 * pi / period, line = 2 * pi / 3600;
        double largest = 0, at = 0;
        for (int band = 5; band < 25; ++band) {
            double energy = 0;
            for (double w = (band - 0.5) * peak / 10; w < (band + 0.5) * peak / 10; w += line) {
                double c = 0, s = 0;
                for (std::size_t i = 0; i < heights.size(); ++i) {
                    c += heights[i] * std::cos(0.5 * w * double(i));
                    s += heights[i] * std::sin(0.5 * w * double(i));
                }
                energy += c * c + s * s;
            }
            if (energy > largest) at = band / 10.0;
            largest = std::max(largest, energy);
        }
        EXPECT_NEAR(at, 1, 0.11) << period;
    }
}

TEST(SeaState, FollowsTheSpectrumBandByBand) {
    SeaStateDef def = sea(infinity, 4);
    def.components = 400;
    const double peak = def.spectrum.peakFrequency();
    for (double begin : {0.5, 0.8, 1.0, 1.2, 1.6, 2.2}) {
        double energy = 0, expected = 0;
        for (const WaveComponent& wave : makeSeaState(def).components)
            if (wave.frequency > begin * peak && wave.frequency < 1.3 * begin * peak)
                energy += wave.amplitude * wave.amplitude / 2;
        for (int i = 0; i < 1000; ++i)
            expected += def.spectrum.density((begin + 0.3 * begin * (i + 0.5) / 1000) * peak) * 0.3 * begin *
                        peak / 1000;
        // A band's ends cut one bin each; half of all bins share the energy evenly.
        EXPECT_NEAR(energy, expected, 2 * 2 * 9.0 / 16 / 400 + 0.01 * expected) << begin;
    }
}

TEST(SeaState, SpreadsAsTheCosineDoes) {
    // The mean of cos(angle) over cos^2s(angle / 2) is s / (s + 1), of sin 0.
    for (double spreading : {0.0, 1.0, 10.0, 75.0}) {
        SeaStateDef def = sea(spreading, 5);
        def.direction = 1;
        def.components = 20000;
        double c = 0, s = 0;
        for (const WaveComponent& wave : makeSeaState(def).components) {
            c += std::cos(wave.direction - 1) / def.components;
            s += std::sin(wave.direction - 1) / def.components;
        }
        // Four deviations of a mean of 20000 numbers whose own is below 0.71.
        EXPECT_NEAR(c, spreading / (spreading + 1), 0.02) << spreading;
        EXPECT_NEAR(s, 0, 0.02) << spreading;
    }
    for (const WaveComponent& wave : makeSeaState(sea(infinity, 6)).components)
        EXPECT_EQ(wave.direction, 0);
}

TEST(SeaState, ObeysTheDispersionOfItsDepth) {
    SeaStateDef def = sea(infinity, 7);
    def.water.depth = 12;
    for (const WaveComponent& wave : makeSeaState(def).components)
        EXPECT_NEAR(frequencyOfWavenumber(wave.wavenumber, def.water), wave.frequency, 1e-13);
}

TEST(SeaState, ServesGerstnerWavesIfNotTooSteep) {
    SeaStateDef def = sea(10, 8);
    def.components = 16;
    def.highestFrequency = 2;
    def.spectrum.significantHeight = 1.5;
    EXPECT_TRUE(GerstnerWaves(WaterFrame::zUp(), {makeSeaState(def).components}).status().accepted());
    def.spectrum.significantHeight = 30;
    EXPECT_EQ(GerstnerWaves(WaterFrame::zUp(), {makeSeaState(def).components}).status().error,
              WaterError::loopedCrest);
}

TEST(SeaState, RefusesWhatIsNoSea) {
    const auto error = [](const auto& change) {
        SeaStateDef def;
        change(def);
        const SeaState state = makeSeaState(def);
        EXPECT_TRUE(state.components.empty());
        return state.status.error;
    };
    using Def = SeaStateDef;
    EXPECT_EQ(error([](Def& d) { d.spectrum.significantHeight = -1; }), WaterError::badSpectrum);
    EXPECT_EQ(error([](Def& d) { d.spectrum.significantHeight = NAN; }), WaterError::notFinite);
    EXPECT_EQ(error([](Def& d) { d.spectrum.peakPeriod = 0; }), WaterError::badSpectrum);
    EXPECT_EQ(error([](Def& d) { d.spectrum.peakEnhancement = 0.5; }), WaterError::badSpectrum);
    EXPECT_EQ(error([](Def& d) { d.spreading = -1; }), WaterError::badSpectrum);
    EXPECT_EQ(error([](Def& d) { d.spreading = NAN; }), WaterError::notFinite);
    EXPECT_EQ(error([](Def& d) { d.components = 0; }), WaterError::badSpectrum);
    EXPECT_EQ(error([](Def& d) { d.highestFrequency = 1; }), WaterError::badSpectrum);
    EXPECT_EQ(error([](Def& d) { d.water.depth = 0; }), WaterError::badDepth);
    EXPECT_EQ(error([](Def& d) { d.water.gravity = -1; }), WaterError::badDepth);
    EXPECT_TRUE(makeSeaState({}).status.accepted());
}

}  // namespace
}  // namespace bullet_buoyancy::test
