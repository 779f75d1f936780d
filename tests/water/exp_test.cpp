#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/water/wave_kernels.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

double expOf(double number) {
    WaveRow powers;
    waveKernels().exp({{number}}, powers);
    return powers.lane[0];
}

TEST(Exp, AgreesWithTheStandardLibrary) {
    Random random(1);
    for (double range : {1e-8, 0.1, 1.0, 10.0, 100.0, 708.0})
        for (int i = 0; i < 2000; ++i) {
            WaveRow numbers, powers;
            for (double& number : numbers.lane)
                number = random.uniform(-range, range);
            waveKernels().exp(numbers, powers);
            for (int k = 0; k < waveLaneCount; ++k) {
                // The standard library's are right to a unit in the last place: 2.2e-16.
                const double expected = std::exp(numbers.lane[k]);
                EXPECT_NEAR(powers.lane[k], expected, 7.2e-16 * expected) << numbers.lane[k];
            }
        }
}

TEST(Exp, AgreesNextToTheEndsOfItsReduction) {
    Random random(2);
    for (int i = -1000; i < 1000; ++i) {
        const double end = (i + 0.5) * std::log(2.0), number = end + random.uniform(-1e-12, 1e-12);
        const double expected = std::exp(number);
        EXPECT_NEAR(expOf(number), expected, 7.2e-16 * expected) << number;
    }
}

TEST(Exp, IsExactAtZeroAndEndsWhereDoublesDo) {
    EXPECT_EQ(expOf(0), 1);
    for (double number : {-710.0, -1e300, -double(INFINITY)})
        EXPECT_EQ(expOf(number), expOf(-708));
    for (double number : {709.5, 1e300, double(INFINITY)})
        EXPECT_EQ(expOf(number), expOf(709));
    EXPECT_GT(expOf(-708), 0);
    EXPECT_TRUE(std::isfinite(expOf(709)));
}

}  // namespace
}  // namespace bullet_buoyancy::test
