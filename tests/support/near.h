#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy::test {

/// Relative distance between neighbouring numbers in double precision.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// For EXPECT_TRUE: vectors or matrices whose difference has a norm of at most `tolerance`.
template <typename A, typename B>
::testing::AssertionResult isNear(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b,
                                  double tolerance) {
    const double difference = (a - b).norm();
    if (difference <= tolerance) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "\n"
                                         << a << "\nand\n"
                                         << b << "\ndiffer by " << difference << ", allowed " << tolerance;
}

}  // namespace bullet_buoyancy::test
