#include "bullet_buoyancy/motion/damping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/hydrodynamics/wet_rate.h"

namespace bullet_buoyancy::test {
namespace {

constexpr double rounding = 1e-14;
const Vec3 none = Vec3::Zero();

TEST(DampedStep, IsTheExactSolutionForAConstantLoad) {
    for (double rate : {1e-9, 0.1, 3.0, 100.0})
        for (double dt : {1e-4, 1.0 / 60, 1.0}) {
            const Vec3 start(2, -1, 0), load(0.5, 3, 0);
            const Vec3 terminal = load / rate;
            const Vec3 expected = terminal + std::exp(-rate * dt) * (start - terminal);
            const Vec3 result = DampedStep(rate, dt).advance(start, load);
            // The closed form cancels where the terminal velocity is large against the change.
            EXPECT_LT((result - expected).norm(), rounding * (4 + 4 * terminal.norm())) << rate << ' ' << dt;
        }
}

TEST(DampedStep, ManySmallOnesAreOneLarge) {
    Vec3 value(1, 2, 3);
    const Vec3 load(-1, 0.5, 0), large = DampedStep(2, 1).advance(value, load);
    for (int i = 0; i < 1000; ++i)
        value = DampedStep(2, 1e-3).advance(value, load);
    EXPECT_LT((value - large).norm(), 1000 * rounding);
}

TEST(DampedStep, WithoutARateIsAPlainKick) {
    EXPECT_EQ(DampedStep(0, 0.5).advance({1, 0, 0}, {0, 4, 0}), Vec3(1, 2, 0));
}

TEST(DampedStep, NeverReversesAMotion) {
    for (double rate : {1.0, 1e3, 1e9, 1e300}) {
        const double left = DampedStep(rate, 0.1).advance({1, 0, 0}, none).x();
        EXPECT_GE(left, 0) << rate;
        EXPECT_LT(left, 1) << rate;
    }
}

/// A body that contacts hold gets all of its load to press against them with, however strong the drag.
TEST(DampedStep, OfABodyThatIsHeldPressesWithTheWholeLoad) {
    const Vec3 load(0, 0, -9.8);
    const DampedStep half(50, 0.05);
    const Vec3 pressed = half.advance(half.advance(none, load), load, half.lostInTwoSteps());
    EXPECT_LT((pressed - 0.1 * load).norm(), rounding * 10);
}

/// Against Simpson's rule with many points.
TEST(DampedStep, TravelIsTheIntegralOfTheValue) {
    const Vec3 start(2, -1, 0), load(0.5, 3, -2);
    for (double rate : {0.0, 1e-7, 0.3, 40.0}) {
        constexpr int intervals = 2000;
        const double dt = 0.1;
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i <= intervals; ++i) {
            const Vec3 value = i == 0 ? start : DampedStep(rate, dt * i / intervals).advance(start, load);
            sum += (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2) * value;
        }
        const Vec3 simpson = sum * dt / (3 * intervals);
        // What drag takes of the load is a difference of nearly equal numbers for small rates.
        EXPECT_LT((DampedStep(rate, dt).travel(start, load) - simpson).norm(), 1e-10) << rate;
    }
}

TEST(Relief, IsTheShareOfALoadThatOthersTakeInTwoStepsRunning) {
    const Vec3 load(0, 0, -10);
    Relief relief;
    const auto shareAfter = [&](const Vec3& others) {
        relief.update(load, others);
        return relief.share();
    };
    EXPECT_EQ(shareAfter({5, 0, 4}), 0);  // once may be a blow
    EXPECT_EQ(shareAfter({0, 0, 4}), 0.4);
    EXPECT_EQ(shareAfter({0, 0, 600}), 0.4);
    EXPECT_EQ(shareAfter({0, 0, 600}), 1);
    EXPECT_EQ(shareAfter({0, 0, -600}), 0);  // pressing on
    relief.update(none, {0, 0, 1});
    EXPECT_EQ(relief.share(), 0);
}

TEST(DampingRate, GivesThePublishedFactorInItsTick) {
    EXPECT_NEAR(std::exp(-0.02 * dampingRate(0.98, 0.02)), 0.98, rounding);
    EXPECT_NEAR(std::exp(-0.02 * dampingRate(0.95, 0.02)), 0.95, rounding);
    EXPECT_EQ(dampingRate(1, 0.02), 0);
}

TEST(WetRate, IsInProportionToWhatIsWet) {
    EXPECT_EQ(wetRate(3, 0, true), 0);
    EXPECT_EQ(wetRate(3, 0.25, true), 0.75);
    EXPECT_EQ(wetRate(3, 1, true), 3);
}

TEST(WetRate, AsPublishedIsFullWheneverWet) {
    EXPECT_EQ(wetRate(3, 0, false), 0);
    EXPECT_EQ(wetRate(3, 1e-6, false), 3);
}

}  // namespace
}  // namespace bullet_buoyancy::test
