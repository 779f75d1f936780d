#include "bullet_buoyancy/motion/rest.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bullet_buoyancy::test {
namespace {

constexpr double gravity = 9.8;

/// By speed and acceleration in shares of what is allowed, for a body of a given length.
bool rests(double speed, double acceleration, double angularAcceleration, double length) {
    const double allowed = 1e-4 * gravity;
    return isAtRest(
        {speed * 0.005 * std::sqrt(gravity * length), acceleration * allowed, angularAcceleration * allowed},
        gravity, length);
}

TEST(Rest, IsWhereABodyIsSlowForItsSizeAndItsLoadsBalance) {
    for (double length : {0.01, 1.0, 100.0}) {
        EXPECT_TRUE(rests(0.9, 0.9, 0.9, length));
        EXPECT_FALSE(rests(1.1, 0, 0, length));
        EXPECT_FALSE(rests(0, 1.1, 0, length));
        EXPECT_FALSE(rests(0, 0, 1.1, length));
    }
}

TEST(Rest, IsNotWhereGravityIsNotUnlessNothingMoves) {
    EXPECT_TRUE(isAtRest({0, 0, 0}, 0, 1));
    EXPECT_FALSE(isAtRest({1e-9, 0, 0}, 0, 1));
}

TEST(Rest, OfABodyThatOthersCarryDoesNotAskForBalance) {
    EXPECT_EQ(unbalanced(5, 1), 0);
    EXPECT_EQ(unbalanced(5, 0.6), 0);
    EXPECT_EQ(unbalanced(5, 0.5), 5);
    EXPECT_EQ(unbalanced(5, 0), 5);
}

}  // namespace
}  // namespace bullet_buoyancy::test
