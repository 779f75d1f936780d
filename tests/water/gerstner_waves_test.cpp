#include "bullet_buoyancy/water/gerstner_waves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/near.h"
#include "support/random_waves.h"
#include "water/field_checks.h"

namespace bullet_buoyancy::test {
namespace {

GerstnerWaves randomGerstner(int count, double steepness, std::uint64_t seed) {
    Random random(seed);
    return GerstnerWaves(WaterFrame::zUp(), {randomWaves(count, steepness, random)});
}

/// What velocities may be off by, m/s.
double velocityTolerance(const std::vector<WaveComponent>& waves) {
    double speed = 0;
    for (const WaveComponent& wave : waves)
        speed += wave.amplitude * wave.frequency;
    return 1e-4 * speed;
}

/// The particle that rests at a place under the surface.
struct Particle {
    Vec3 place, velocity = Vec3::Zero();

    Particle(const std::vector<WaveComponent>& waves, const Vec3& rest, double time) : place(rest) {
        for (const WaveComponent& wave : waves) {
            const Vec3 way(std::cos(wave.direction), std::sin(wave.direction), 0);
            const double theta = wave.wavenumber * way.dot(rest) - wave.frequency * time + wave.phase;
            const double radius = wave.amplitude * std::exp(wave.wavenumber * rest.z());
            place += radius * (std::cos(theta) * Vec3::UnitZ() - std::sin(theta) * way);
            velocity += radius * wave.frequency * (std::sin(theta) * Vec3::UnitZ() + std::cos(theta) * way);
        }
    }
};

/// Gerstner (1802): x = a + e^(k b) / k sin k(a + c t), z = b - e^(k b) / k cos k(a + c t), free surface
/// b = -8 m, wavelength 50 m, g = 9.81 m/s^2, travelling towards -x.
struct PublishedWave {
    double k = 2 * pi / 50, surface = -8, c = std::sqrt(9.81 / k);

    double radius(double b) const { return std::exp(k * b) / k; }
    double angle(double a, double t) const { return k * (a + c * t); }

    /// With the frame's z = 0 at the particles' resting height in the surface.
    GerstnerWaves field() const {
        return GerstnerWaves(WaterFrame::zUp(), {{{radius(surface), k, pi, k * c, pi}}});
    }
};

TEST(GerstnerWaves, OneWaveIsThePublishedOne) {
    const PublishedWave wave;
    EXPECT_NEAR(wave.radius(-8), 2.9119888, 5e-8);
    EXPECT_NEAR(frequencyOfWavenumber(wave.k, {INFINITY, 9.81}) / wave.k, 8.8354683, 5e-8);
    const GerstnerWaves water = wave.field();
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.uniform(-100, 100), t = random.uniform(0, 100), u = wave.angle(a, t);
        const double radius = wave.radius(-8);
        const Eigen::Array3d sample = surfaceAt(water, a + radius * std::sin(u), random.uniform(-9, 9), t);
        EXPECT_NEAR(sample[0], -radius * std::cos(u), 1e-9);
        EXPECT_NEAR(sample[1], wave.k * radius * std::sin(u) / (1 + wave.k * radius * std::cos(u)), 1e-8);
        EXPECT_NEAR(sample[2], 0, 1e-9);
    }
}

TEST(GerstnerWaves, ParticlesOfOneWaveGoInThePublishedCircles) {
    const PublishedWave wave;
    const GerstnerWaves water = wave.field();
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.uniform(-100, 100), t = random.uniform(0, 100), u = wave.angle(a, t);
        const double b = random.uniform(-30, -8), radius = wave.radius(b);
        const Vec3 place(a + radius * std::sin(u), 3, b - wave.surface - radius * std::cos(u));
        const double speed = radius * wave.k * wave.c;
        EXPECT_TRUE(isNear(velocityAt(water, place, t), Vec3(speed * std::cos(u), 0, speed * std::sin(u)),
                           1e-4 * wave.radius(-8) * wave.k * wave.c));
    }
}

TEST(GerstnerWaves, MeanLevelOfOneWaveIsThePublishedOne) {
    const GerstnerWaves water = PublishedWave().field();
    // A periodic function's mean by equal steps is right to rounding.
    double mean = 0;
    for (int i = 0; i < 1000; ++i)
        mean += surfaceAt(water, 0.05 * i, 0, 7)[0] / 1000;
    EXPECT_NEAR(mean - 8, -8.5327939, 5e-8);
    EXPECT_NEAR(water.meanLevel(), mean, 1e-9);
}

TEST(GerstnerWaves, FindsTheParticleAtAnyPlace) {
    for (double steepness : {0.1, 0.5, 0.8, 0.95})
        for (int count : {1, 2, 5, 16}) {
            Random random(3);
            for (int sea = 0; sea < 10; ++sea) {
                const auto waves = randomWaves(count, steepness, random);
                const GerstnerWaves water(WaterFrame::zUp(), {waves});
                for (int i = 0; i < 200; ++i) {
                    const Vec2 rest(random.uniform(-50, 50), random.uniform(-50, 50));
                    const double t = random.uniform(0, 50);
                    Vec2 place = rest;
                    double height = 0;
                    for (const WaveComponent& wave : waves) {
                        const Vec2 way(std::cos(wave.direction), std::sin(wave.direction));
                        const double theta =
                            wave.wavenumber * way.dot(rest) - wave.frequency * t + wave.phase;
                        place -= wave.amplitude * std::sin(theta) * way;
                        height += wave.amplitude * std::cos(theta);
                    }
                    EXPECT_NEAR(surfaceAt(water, place.x(), place.y(), t)[0], height, 1e-9) << steepness;
                }
            }
        }
}

TEST(GerstnerWaves, FindsTheParticleAtCrestsThatAreNearlyCusps) {
    // All crests meet at the origin at time 0.
    for (double steepness : {0.9, 0.99, 0.999}) {
        std::vector<WaveComponent> waves;
        for (int i = 0; i < 4; ++i) {
            const double k = 0.3 * (i + 1);
            waves.push_back({steepness / 4 / k, k, 0.2 * i, 1, 0});
        }
        const GerstnerWaves water(WaterFrame::zUp(), {waves});
        EXPECT_NEAR(surfaceAt(water, 0, 0, 0)[0], water.bounds().elevation, 1e-12);
        Random random(4);
        for (int i = 0; i < 1000; ++i) {
            const double size = std::pow(10, random.uniform(-8, 0));
            const Vec2 rest(random.uniform(-size, size), random.uniform(-size, size));
            Vec2 place = rest;
            double height = 0;
            for (const WaveComponent& wave : waves) {
                const Vec2 way(std::cos(wave.direction), std::sin(wave.direction));
                place -= wave.amplitude * std::sin(wave.wavenumber * way.dot(rest)) * way;
                height += wave.amplitude * std::cos(wave.wavenumber * way.dot(rest));
            }
            EXPECT_NEAR(surfaceAt(water, place.x(), place.y(), 0)[0], height, 1e-9)
                << steepness << " " << size;
        }
    }
}

TEST(GerstnerWaves, HasTheDerivativesOfItsSurface) {
    // Differences over 1e-4 m are off by 1e-8 / 6 times a derivative that steepness makes larger, and by the
    // search's 1e-12 m / 1e-4 m.
    expectSurfaceDerivatives(randomGerstner(5, 0.3, 5), {1e-4, 5e-8, 100});
    expectSurfaceDerivatives(randomGerstner(16, 0.6, 6), {1e-4, 5e-7, 100});
}

TEST(GerstnerWaves, HeadIsHydrostatic) {
    const GerstnerWaves water = randomGerstner(5, 0.3, 7);
    expectHeadDerivatives(water, {1e-4, 5e-8, 100});
    EXPECT_EQ(headAt(water, 1, 2, -5, 3)[0], headAt(water, 1, 2, 0, 3)[0]);
    EXPECT_EQ(water.headCurvatureChange(1), water.bounds().curvatureChange);
}

TEST(GerstnerWaves, KeepsWithinItsBounds) {
    for (double steepness : {0.2, 0.5, 0.8})
        for (int count : {1, 3, 12}) {
            const GerstnerWaves water = randomGerstner(count, steepness, 8);
            const WaterBounds bounds = water.bounds(), found = searchBounds(water, 60, true);
            EXPECT_LE(found.elevation, bounds.elevation * (1 + 1e-12));
            EXPECT_LE(found.slope, bounds.slope);
            EXPECT_LE(found.curvature, bounds.curvature * (1 + 1e-6));
            EXPECT_LE(found.curvatureChange, bounds.curvatureChange * (1 + 1e-6));
            // One crest is as sharp as amplitude k^2 / (1 - steepness)^2: the bound is that over 1 -
            // steepness.
            if (count > 1) continue;
            EXPECT_GE(found.curvature, 0.99 * (1 - steepness) * bounds.curvature);
        }
}

/// What is told is not idle: the third derivative comes near to it somewhere, and it is far below what holds
/// anywhere.
TEST(GerstnerWaves, TellsTheThirdDerivativeAtAPoint) {
    for (double steepness : {0.2, 0.5})
        for (int count : {1, 3, 12}) {
            const GerstnerWaves water = randomGerstner(count, steepness, 13);
            const WaterBounds bounds = water.bounds();
            Random random(14);
            double nearest = 0, mean = 0;
            constexpr int places = 300;
            for (int i = 0; i < places; ++i) {
                const double x = random.uniform(-50, 50), y = random.uniform(-50, 50),
                             t = random.uniform(0, 50), told = expansionAt(water, x, y, t)[6];
                double largest = 0;
                for (double angle = 0; angle < pi; angle += pi / 24) {
                    const double h = 1e-3, dx = std::cos(angle), dy = std::sin(angle);
                    const auto second = [&](double step) {
                        const auto at = expansionAt(water, x + step * dx, y + step * dy, t);
                        return dx * dx * at[3] + 2 * dx * dy * at[4] + dy * dy * at[5];
                    };
                    largest = std::max(largest, std::abs(second(h) - second(-h)) / (2 * h));
                }
                // Differences of second derivatives that are right to 1e-8 are right to 1e-5.
                EXPECT_LE(largest, told + 1e-5);
                nearest = std::max(nearest, largest / told);
                mean += told / places;
            }
            EXPECT_GT(nearest, 0.9);
            EXPECT_LT(mean, 0.5 * bounds.curvatureChange);
        }
}

/// Of the fourth derivative along lines, by third differences of slopes.
TEST(GerstnerWaves, KeepsWithinTheGrowthOfItsThirdDerivative) {
    for (double steepness : {0.2, 0.5, 0.8})
        for (int count : {1, 3, 12}) {
            const GerstnerWaves water = randomGerstner(count, steepness, 15);
            const double h = 0.02, bound = water.bounds().curvatureChangeGrowth;
            const double found = searchLargest(
                [&](double x, double y, double t, double angle, double) {
                    const double dx = std::cos(angle), dy = std::sin(angle);
                    const auto second = [&](double step) {
                        const auto at = expansionAt(water, x + step * dx, y + step * dy, t);
                        return dx * dx * at[3] + 2 * dx * dy * at[4] + dy * dy * at[5];
                    };
                    return std::abs(second(h) - 2 * second(0) + second(-h)) / (h * h);
                },
                60);
            // A second difference is a mean of the derivative, but for second derivatives right to 1e-8.
            EXPECT_LE(found, bound + 4e-8 / (h * h)) << steepness << " " << count;
            if (count > 1) continue;
            // That of one crest is s k^3 (1 + 3 s) / (1 - s)^5, from the series of place and height.
            const double j = 1 / (1 - steepness);
            const double k = water.bounds().curvature / (steepness * std::pow(j, 3));
            const double crest = steepness * std::pow(k, 3) * (1 + 3 * steepness) * std::pow(j, 5);
            EXPECT_GE(found, 0.9 * crest) << steepness;
        }
}

TEST(GerstnerWaves, AboveTheSurfaceMovesAsTheSurface) {
    Random random(9);
    const auto waves = randomWaves(5, 0.5, random);
    const GerstnerWaves water(WaterFrame::zUp(), {waves});
    const double tolerance = velocityTolerance(waves);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 rest(random.uniform(-50, 50), random.uniform(-50, 50), 0);
        const Particle particle(waves, rest, 7);
        EXPECT_TRUE(isNear(velocityAt(water, particle.place, 7), particle.velocity, tolerance));
        EXPECT_TRUE(
            isNear(velocityAt(water, particle.place + 5 * Vec3::UnitZ(), 7), particle.velocity, tolerance));
    }
}

TEST(GerstnerWaves, FindsParticlesUnderTheSurface) {
    for (double steepness : {0.02, 0.2, 0.5, 0.9})
        for (int count : {1, 3, 6, 16}) {
            Random random(11);
            const auto waves = randomWaves(count, steepness, random);
            const GerstnerWaves water(WaterFrame::zUp(), {waves});
            for (int i = 0; i < 1000; ++i) {
                const double depth = std::exp(random.uniform(-6, 3));
                const Vec3 rest(random.uniform(-50, 50), random.uniform(-50, 50), -depth);
                const Particle particle(waves, rest, 7);
                EXPECT_TRUE(
                    isNear(velocityAt(water, particle.place, 7), particle.velocity, velocityTolerance(waves)))
                    << steepness << " " << count << " " << rest.transpose();
            }
        }
}

TEST(GerstnerWaves, RefusesLoopedCrests) {
    const GerstnerWaves looped(WaterFrame::zUp(), {{{0.75, 1, 0, 3, 0}, {0.25, 2, 0, 4, 0}}});
    EXPECT_EQ(looped.status().error, WaterError::loopedCrest);
    EXPECT_EQ(looped.status().steepness, 1.25);
    EXPECT_NE(looped.status().describe().find("1.25"), std::string::npos);
    EXPECT_TRUE(looped.bounds().isFlat());
    EXPECT_EQ(surfaceAt(looped, 1, 2, 3)[0], 0);
    EXPECT_EQ(GerstnerWaves(WaterFrame::zUp(), {{{1, 1, 0, 3, 0}}}).status().error, WaterError::loopedCrest);
    EXPECT_TRUE(GerstnerWaves(WaterFrame::zUp(), {{{0.999, 1, 0, 3, 0}}}).status().accepted());
    EXPECT_EQ(GerstnerWaves(WaterFrame::zUp(), {{{NAN, 1, 0, 3, 0}}}).status().error, WaterError::notFinite);
}

TEST(GerstnerWaves, EndsItsSearchForPlacesThatAreNone) {
    const GerstnerWaves water = randomGerstner(5, 0.5, 12);
    EXPECT_TRUE(std::isnan(surfaceAt(water, NAN, 0, 0)[0]));
    EXPECT_TRUE(std::isnan(velocityAt(water, {NAN, 0, -1}, 0).x()));
}

}  // namespace
}  // namespace bullet_buoyancy::test
