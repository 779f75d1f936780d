#include "bullet_buoyancy/water/wave_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/pack_waves.h"
#include "support/instruction_sets.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

struct Place {
    double x, y, z;
};

/// All that the kernels of a set tell of waves at a place.
struct Outcome {
    double surface[3], bentSurface[10], head[10], velocity[3], trochoid[24] = {}, bentTrochoid[24],
                                                               particle[16];

    Outcome(InstructionSet set, const WavesAtTime& waves, const Place& at) {
        const WaveKernels& kernels = waveKernels(set);
        kernels.surface(waves, at.x, at.y, surface);
        kernels.bentSurface(waves, at.x, at.y, bentSurface);
        kernels.head(waves, at.x, at.y, at.z, head);
        kernels.velocity(waves, at.x, at.y, at.z, velocity);
        kernels.trochoid(waves, at.x, at.y, trochoid);
        kernels.bentTrochoid(waves, at.x, at.y, bentTrochoid);
        kernels.particle(waves, at.x, at.y, at.z, particle);
    }

    bool operator==(const Outcome& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};

std::vector<WaveComponent> randomWaves(int count, Random& random) {
    std::vector<WaveComponent> waves;
    for (int i = 0; i < count; ++i)
        waves.push_back({random.uniform(0, 1), random.uniform(0.1, 2), random.uniform(-pi, pi),
                         random.uniform(0, 3), random.uniform(-pi, pi)});
    return waves;
}

TEST(WaveKernels, AreTheSameToTheLastBit) {
    Random random(1);
    for (int count : {1, 2, 7, 8, 9, 16, 61})
        for (double depth : {3.0, double(INFINITY)})
            for (int i = 0; i < 30; ++i) {
                const auto lanes = packWaves(randomWaves(count, random), depth);
                const WavesAtTime waves{lanes.data(), int(lanes.size()), random.uniform(0, 100), depth};
                const Place place{random.uniform(-100, 100), random.uniform(-100, 100),
                                  random.uniform(-3, 0)};
                const Outcome portable(InstructionSet::portable, waves, place);
                for (InstructionSet set : setsOfThisMachine())
                    EXPECT_TRUE(Outcome(set, waves, place) == portable) << nameOf(set);
            }
}

TEST(WaveKernels, HaveFunctionsThatAreTheSameToTheLastBit) {
    Random random(3);
    for (double range : {1.0, 100.0, 1e6})
        for (int i = 0; i < 1000; ++i) {
            WaveRow numbers;
            for (double& number : numbers.lane)
                number = random.uniform(-range, range);
            WaveRow portable[3];
            waveKernels(InstructionSet::portable).sinCos(numbers, portable[0], portable[1]);
            waveKernels(InstructionSet::portable).exp(numbers, portable[2]);
            for (InstructionSet set : setsOfThisMachine()) {
                WaveRow rows[3];
                waveKernels(set).sinCos(numbers, rows[0], rows[1]);
                waveKernels(set).exp(numbers, rows[2]);
                EXPECT_EQ(std::memcmp(rows, portable, sizeof rows), 0) << nameOf(set);
            }
        }
}

/// The sums of one kernel are part of another's.
TEST(WaveKernels, AgreeWithEachOther) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const auto lanes = packWaves(randomWaves(11, random));
        const WavesAtTime waves{lanes.data(), int(lanes.size()), random.uniform(0, 100), INFINITY};
        const Outcome at(bestInstructionSet(), waves,
                         {random.uniform(-100, 100), random.uniform(-100, 100), 0});
        EXPECT_EQ(0, std::memcmp(at.surface, at.bentSurface, sizeof at.surface));
        EXPECT_EQ(0, std::memcmp(at.trochoid, at.bentTrochoid, 15 * sizeof(double)));
        // At the surface, to the rounding of the eleven summands of at most 1, differently grouped.
        constexpr double rounding = 11 * 4e-16;
        EXPECT_NEAR(at.head[0], at.surface[0], rounding);
        EXPECT_NEAR(at.trochoid[2], at.surface[0], rounding);
        EXPECT_NEAR(at.particle[0], -at.trochoid[0], rounding);
        EXPECT_NEAR(at.particle[1], -at.trochoid[1], rounding);
        EXPECT_NEAR(at.particle[2], at.trochoid[2], rounding);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
