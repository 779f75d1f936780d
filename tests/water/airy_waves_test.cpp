#include "bullet_buoyancy/water/airy_waves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/near.h"
#include "support/random_waves.h"
#include "water/field_checks.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

AiryWaves randomAiry(int count, double steepness, double depth, std::uint64_t seed) {
    Random random(seed);
    return AiryWaves(WaterFrame::zUp(), {randomWaves(count, steepness, random, {depth, 9.81}), depth, 1000});
}

AiryWaves oneWave(double depth) {
    const double k = 0.3;
    return AiryWaves(WaterFrame::zUp(),
                     {{{0.5, k, 0.7, frequencyOfWavenumber(k, {depth, 9.81}), 0.2}}, depth, 1000});
}

TEST(AiryWaves, IsTheSumOfItsCosines) {
    Random random(1);
    for (int count : {0, 1, 7, 8, 9, 30}) {
        const auto waves = randomWaves(count, 0.3, random);
        const AiryWaves water(WaterFrame::zUp(), {waves});
        for (int i = 0; i < 20; ++i) {
            const double x = random.uniform(-100, 100), y = random.uniform(-100, 100),
                         t = random.uniform(0, 100);
            double sum = 0;
            for (const WaveComponent& wave : waves)
                sum +=
                    wave.amplitude *
                    std::cos(wave.wavenumber * (x * std::cos(wave.direction) + y * std::sin(wave.direction)) -
                             wave.frequency * t + wave.phase);
            // Phases of up to 1000 rad round by 1e-13; amplitudes add up to 3 m.
            EXPECT_NEAR(surfaceAt(water, x, y, t)[0], sum, 1e-12);
        }
    }
}

TEST(AiryWaves, HasTheDerivativesOfItsSurface) {
    // Differences over 1e-4 m are off by 1e-8 / 6 times a derivative of up to steepness * k^3 = 1.2, and by
    // rounding of 1e-12 m / 1e-4 m.
    expectSurfaceDerivatives(randomAiry(13, 0.3, infinity, 2), {1e-4, 2e-8, 100});
    expectSurfaceDerivatives(randomAiry(13, 0.3, 5, 3), {1e-4, 2e-8, 100});
}

TEST(AiryWaves, HasTheDerivativesOfItsHead) {
    for (double depth : {infinity, 30.0, 5.0})
        expectHeadDerivatives(randomAiry(13, 0.3, depth, 4), {1e-4, 3e-8, 100});
}

TEST(AiryWaves, HeadOfOneWaveFallsAsThePotentialDoes) {
    for (double depth : {infinity, 10.0, 3.0}) {
        const AiryWaves water = oneWave(depth);
        for (double s : {-2.5, -1.0, 0.0, 0.5}) {
            const double decay =
                std::isinf(depth) ? std::exp(0.3 * s) : std::cosh(0.3 * (depth + s)) / std::cosh(0.3 * depth);
            EXPECT_NEAR(headAt(water, 3, 4, s, 5)[0], decay * surfaceAt(water, 3, 4, 5)[0], 1e-14);
            // Laplace's equation.
            const auto head = headAt(water, 3, 4, s, 5);
            EXPECT_NEAR(head[4] + head[6] + head[9], 0, 1e-15);
        }
    }
}

TEST(AiryWaves, HeadIsFiniteHoweverDeep) {
    for (double depth : {infinity, 10.0}) {
        const AiryWaves water = randomAiry(9, 0.3, depth, 5);
        for (double s : {-1e2, -1e4, -1e8})
            EXPECT_TRUE(headAt(water, 1, 2, s, 3).isFinite().all()) << depth << " " << s;
    }
}

TEST(AiryWaves, MovesAsThePotentialDoes) {
    const double k = 0.3, a = 0.5;
    for (double depth : {infinity, 10.0, 3.0}) {
        const AiryWaves water = oneWave(depth);
        const double frequency = frequencyOfWavenumber(k, {depth, 9.81});
        Random random(6);
        for (int i = 0; i < 100; ++i) {
            const double x = random.uniform(-50, 50), y = random.uniform(-50, 50), t = random.uniform(0, 50);
            const double s = random.uniform(-2.9, 0),
                         theta = k * (x * std::cos(0.7) + y * std::sin(0.7)) - frequency * t + 0.2;
            const Vec3 velocity = velocityAt(water, {x, y, surfaceAt(water, x, y, t)[0] + s}, t);
            // a g k / omega cosh / cosh in the way of travel, the same with sinh upwards (Airy 1845).
            const double speed = a * 9.81 * k / frequency;
            const double even =
                std::isinf(depth) ? std::exp(k * s) : std::cosh(k * (depth + s)) / std::cosh(k * depth);
            const double odd = std::isinf(depth) ? even : std::sinh(k * (depth + s)) / std::cosh(k * depth);
            const Vec3 expected(speed * even * std::cos(theta) * std::cos(0.7),
                                speed * even * std::cos(theta) * std::sin(0.7),
                                speed * odd * std::sin(theta));
            EXPECT_TRUE(isNear(velocity, expected, 1e-13));
        }
    }
}

TEST(AiryWaves, LosesNoWaterButByTheStretching) {
    // Velocity is u(x, y, z - eta) with div u = 0: what is left is -du/ds . grad eta.
    for (double depth : {infinity, 5.0}) {
        const AiryWaves water = randomAiry(11, 0.2, depth, 7);
        Random random(8);
        const double h = 1e-4;
        for (int i = 0; i < 100; ++i) {
            const double t = random.uniform(0, 50);
            Vec3 place(random.uniform(-50, 50), random.uniform(-50, 50), 0);
            const Eigen::Array3d surface = surfaceAt(water, place.x(), place.y(), t);
            place.z() = surface[0] + random.uniform(-3, -0.01);
            Mat3 by;
            for (int axis = 0; axis < 3; ++axis)
                by.col(axis) = (velocityAt(water, place + h * Vec3::Unit(axis), t) -
                                velocityAt(water, place - h * Vec3::Unit(axis), t)) /
                               (2 * h);
            EXPECT_NEAR(by.trace(), -by(0, 2) * surface[1] - by(1, 2) * surface[2], 2e-8);
        }
    }
}

TEST(AiryWaves, SurfaceMovesWithTheWater) {
    // d eta / dt is the vertical velocity at the surface, in linear theory.
    for (double depth : {infinity, 5.0}) {
        const AiryWaves water = randomAiry(11, 0.2, depth, 9);
        Random random(10);
        const double h = 1e-4;
        for (int i = 0; i < 100; ++i) {
            const double x = random.uniform(-50, 50), y = random.uniform(-50, 50), t = random.uniform(0, 50);
            const double rate =
                (surfaceAt(water, x, y, t + h)[0] - surfaceAt(water, x, y, t - h)[0]) / (2 * h);
            EXPECT_NEAR(velocityAt(water, {x, y, surfaceAt(water, x, y, t)[0]}, t).z(), rate, 1e-7);
            EXPECT_TRUE(isNear(velocityAt(water, {x, y, 50}, t),
                               velocityAt(water, {x, y, surfaceAt(water, x, y, t)[0]}, t), 1e-12));
        }
    }
}

TEST(AiryWaves, KeepsWithinItsBounds) {
    for (int count : {1, 3, 12})
        for (double depth : {infinity, 4.0}) {
            const AiryWaves water = randomAiry(count, 0.4, depth, 11);
            const WaterBounds bounds = water.bounds(), found = searchBounds(water, 60, true);
            // Differences overshoot by no more than 1e-6.
            EXPECT_LE(found.elevation, bounds.elevation * (1 + 1e-12));
            EXPECT_LE(found.slope, bounds.slope * (1 + 1e-12));
            EXPECT_LE(found.curvature, bounds.curvature * (1 + 1e-6));
            EXPECT_LE(found.curvatureChange, bounds.curvatureChange * (1 + 1e-6));
            if (count > 1) continue;
            EXPECT_GE(found.elevation, 0.999 * bounds.elevation);
            EXPECT_GE(found.slope, 0.999 * bounds.slope);
            EXPECT_GE(found.curvature, 0.999 * bounds.curvature);
            EXPECT_GE(found.curvatureChange, 0.999 * bounds.curvatureChange);
        }
}

TEST(AiryWaves, HeadKeepsWithinTheBoundOfItsThirdDerivative) {
    for (int count : {1, 3, 12})
        for (double depth : {infinity, 4.0})
            for (double above : {-1.0, 0.0, 1.0}) {
                const AiryWaves water = randomAiry(count, 0.4, depth, 12);
                const double bound = water.headCurvatureChange(above);
                const double found = searchHeadCurvatureChange(water, 60, -std::min(depth, 6.0), above);
                // Differences over 0.02 m are off by (0.02 k)^2 / 4 of the wave's own third derivative.
                EXPECT_LE(found, bound * 1.001) << count << " " << depth << " " << above;
                // It is not idle: one wave comes near.
                if (count > 1) continue;
                EXPECT_GE(found, 0.2 * bound) << depth << " " << above;
            }
}

TEST(AiryWaves, IsStillOnlyWithoutWaves) {
    EXPECT_TRUE(AiryWaves(WaterFrame::zUp(), {}).bounds().still);
    EXPECT_TRUE(AiryWaves(WaterFrame::zUp(), {}).bounds().isFlat());
    EXPECT_FALSE(oneWave(infinity).bounds().still);
    EXPECT_EQ(AiryWaves(WaterFrame::zUp(), {}).headCurvatureChange(10), 0);
}

TEST(AiryWaves, RefusesWhatIsNoWave) {
    const auto error = [](const WaveComponent& wave, double depth = infinity) {
        const AiryWaves water(WaterFrame::zUp(), {{wave}, depth, 1000});
        EXPECT_TRUE(water.bounds().isFlat());
        EXPECT_EQ(surfaceAt(water, 1, 2, 3)[0], 0);
        return water.status().error;
    };
    EXPECT_EQ(error({-1, 1, 0, 1, 0}), WaterError::badComponent);
    EXPECT_EQ(error({1, 0, 0, 1, 0}), WaterError::badComponent);
    EXPECT_EQ(error({1, 1, 0, NAN, 0}), WaterError::notFinite);
    EXPECT_EQ(error({1, 1, infinity, 1, 0}), WaterError::notFinite);
    EXPECT_EQ(error({1, 1, 0, 1, 0}, 0), WaterError::badDepth);
    EXPECT_EQ(error({1, 1, 0, 1, 0}, NAN), WaterError::badDepth);
    EXPECT_TRUE(oneWave(3).status().accepted());
    EXPECT_EQ(oneWave(3).status().describe(), "ok");
}

}  // namespace
}  // namespace bullet_buoyancy::test
