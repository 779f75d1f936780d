#include "bullet_buoyancy/core/exp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

using Eight = Eigen::Array<double, 8, 1>;

TEST(Exp, AgreesWithTheStandardLibrary) {
    Random random(1);
    for (double range : {1e-8, 0.1, 1.0, 10.0, 100.0, 708.0})
        for (int i = 0; i < 2000; ++i) {
            Eight numbers;
            for (double& number : numbers)
                number = random.uniform(-range, range);
            const Eight powers = expOf<8>(numbers);
            for (Eigen::Index k = 0; k < 8; ++k) {
                // The standard library's are right to a unit in the last place: 2.2e-16.
                const double expected = std::exp(numbers[k]);
                EXPECT_NEAR(powers[k], expected, 7.2e-16 * expected) << numbers[k];
            }
        }
}

TEST(Exp, AgreesNextToTheEndsOfItsReduction) {
    Random random(2);
    for (int i = -1000; i < 1000; ++i) {
        const double end = (i + 0.5) * std::log(2.0), number = end + random.uniform(-1e-12, 1e-12);
        const double expected = std::exp(number);
        EXPECT_NEAR(expOf<8>(Eight::Constant(number))[0], expected, 7.2e-16 * expected) << number;
    }
}

TEST(Exp, IsExactAtZeroAndEndsWhereDoublesDo) {
    EXPECT_TRUE((expOf<8>(Eight::Zero()) == 1).all());
    for (double number : {-710.0, -1e300, -double(INFINITY)})
        EXPECT_EQ(expOf<8>(Eight::Constant(number))[0], expOf<8>(Eight::Constant(-708))[0]);
    for (double number : {709.5, 1e300, double(INFINITY)})
        EXPECT_EQ(expOf<8>(Eight::Constant(number))[0], expOf<8>(Eight::Constant(709))[0]);
    EXPECT_GT(expOf<8>(Eight::Constant(-708))[0], 0);
    EXPECT_TRUE(std::isfinite(expOf<8>(Eight::Constant(709))[0]));
}

}  // namespace
}  // namespace bullet_buoyancy::test
