#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/wave_kernels.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

void expectSinCos(const WaveRow& angles) {
    WaveRow sines, cosines;
    waveKernels().sinCos(angles, sines, cosines);
    for (int i = 0; i < waveLaneCount; ++i) {
        // The standard library's are right to half a unit in the last place of numbers up to 1: 1.2e-16.
        EXPECT_NEAR(sines.lane[i], std::sin(angles.lane[i]), 6.2e-16) << angles.lane[i];
        EXPECT_NEAR(cosines.lane[i], std::cos(angles.lane[i]), 6.2e-16) << angles.lane[i];
    }
}

TEST(SinCos, AgreesWithTheStandardLibraryUpToFiftyMillion) {
    Random random(1);
    for (double range : {1e-8, 0.1, 1.0, 10.0, 1e3, 1e6, 5e7})
        for (int i = 0; i < 2000; ++i) {
            WaveRow angles;
            for (double& angle : angles.lane)
                angle = random.uniform(-range, range);
            expectSinCos(angles);
        }
}

TEST(SinCos, AgreesNextToTheEndsOfItsReduction) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        WaveRow angles;
        for (double& angle : angles.lane)
            angle = double(random.index(30000000)) * (pi / 2) + random.uniform(-1e-9, 1e-9);
        expectSinCos(angles);
    }
}

TEST(SinCos, IsExactAtZero) {
    WaveRow sines, cosines;
    waveKernels().sinCos({{0.0, -0.0}}, sines, cosines);
    for (double sine : sines.lane)
        EXPECT_EQ(sine, 0);
    for (double cosine : cosines.lane)
        EXPECT_EQ(cosine, 1);
}

}  // namespace
}  // namespace bullet_buoyancy::test
