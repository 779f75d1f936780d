#include "bullet_buoyancy/core/sin_cos.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bullet_buoyancy/core/constants.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

void expectSinCos(const Eigen::Array<double, 8, 1>& angles) {
    Eigen::Array<double, 8, 1> sine, cosine;
    sinCos<8>(angles, sine, cosine);
    for (Eigen::Index i = 0; i < 8; ++i) {
        // The standard library's are right to half a unit in the last place of numbers up to 1: 1.2e-16.
        EXPECT_NEAR(sine[i], std::sin(angles[i]), 6.2e-16) << angles[i];
        EXPECT_NEAR(cosine[i], std::cos(angles[i]), 6.2e-16) << angles[i];
    }
}

TEST(SinCos, AgreesWithTheStandardLibraryUpToFiftyMillion) {
    Random random(1);
    for (double range : {1e-8, 0.1, 1.0, 10.0, 1e3, 1e6, 5e7})
        for (int i = 0; i < 2000; ++i) {
            Eigen::Array<double, 8, 1> angles;
            for (double& angle : angles)
                angle = random.uniform(-range, range);
            expectSinCos(angles);
        }
}

TEST(SinCos, AgreesNextToTheEndsOfItsReduction) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        Eigen::Array<double, 8, 1> angles;
        for (double& angle : angles)
            angle = double(random.index(30000000)) * (pi / 2) + random.uniform(-1e-9, 1e-9);
        expectSinCos(angles);
    }
}

TEST(SinCos, IsExactAtZero) {
    Eigen::Array<double, 2, 1> sine, cosine;
    sinCos<2>({0.0, -0.0}, sine, cosine);
    EXPECT_TRUE((sine == 0).all());
    EXPECT_TRUE((cosine == 1).all());
}

}  // namespace
}  // namespace bullet_buoyancy::test
