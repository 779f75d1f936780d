#include "bullet_buoyancy/water/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

TEST(Dispersion, GivesThePublishedWavenumbers) {
    // Roots of omega^2 = g k tanh(k h) to ten digits, g = 9.81.
    const double table[][3] = {{8, 10, .0886224446},  {8, 20, .0707624287}, {8, 50, .0631085968},
                               {10, 20, .0518256815}, {5, 10, .1717028445}, {12, 30, .0354897788}};
    for (const auto& [period, depth, wavenumber] : table)
        EXPECT_NEAR(wavenumberOfFrequency(2 * pi / period, {depth, 9.81}), wavenumber,
                    1e-9 * wavenumber + 5e-11);
}

TEST(Dispersion, GoesThereAndBackAtAnyDepth) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const double depth = std::exp(random.uniform(-5, 12)), frequency = std::exp(random.uniform(-12, 6));
        const double wavenumber = wavenumberOfFrequency(frequency, {depth, 9.81});
        // The square root and tanh round once each; the condition number of both ways is at most 2.
        EXPECT_NEAR(frequencyOfWavenumber(wavenumber, {depth, 9.81}) / frequency, 1, 1e-14)
            << depth << " " << frequency;
    }
}

TEST(Dispersion, SolvesTheRelationItself) {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const double depth = std::exp(random.uniform(-5, 12)), frequency = std::exp(random.uniform(-6, 6));
        const double k = wavenumberOfFrequency(frequency, {depth, 9.81});
        EXPECT_NEAR(9.81 * k * std::tanh(k * depth) / (frequency * frequency), 1, 1e-14);
    }
}

TEST(Dispersion, HasTheLimitsOfDeepAndShallowWater) {
    for (double frequency : {0.1, 1.0, 10.0}) {
        EXPECT_DOUBLE_EQ(wavenumberOfFrequency(frequency), frequency * frequency / standardGravity);
        EXPECT_DOUBLE_EQ(wavenumberOfFrequency(frequency, {1e6, 9.81}), frequency * frequency / 9.81);
    }
    // tanh q = q (1 - q^2 / 3): off by q^2 / 6.
    EXPECT_NEAR(wavenumberOfFrequency(1e-4, {10, 9.81}) * std::sqrt(98.1) / 1e-4, 1, 1e-8);
    EXPECT_EQ(wavenumberOfFrequency(0), 0);
    EXPECT_EQ(wavenumberOfFrequency(0, {10, 9.81}), 0);
    EXPECT_EQ(frequencyOfWavenumber(0), 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
