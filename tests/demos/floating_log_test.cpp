#include "scenes/floating_log.h"

#include <gtest/gtest.h>

#include "bullet_buoyancy/core/constants.h"
#include "scenes/known_answers.h"

namespace bullet_buoyancy::scenes {
namespace {

constexpr double degree = pi / 180;

/// Where the restoring moment vanishes a log takes for ever to settle.
constexpr double nearThreshold = 0.01;

/// Left by the end of settling; the rounding of Bullet's pose in single precision is a thousand times less.
constexpr double tiltTolerance = 0.05 * degree;
constexpr double heightTolerance = 1e-4;

TEST(FloatingLog, TiltsAndDraftsFollowTheAnalyticCurve) {
    for (int percent = 5; percent <= 95; ++percent) {
        const double ratio = percent / 100.0;
        if (distanceFromLogThreshold(ratio) < nearThreshold) continue;
        const LogResult log = floatLog(ratio);
        EXPECT_NEAR(log.tilt, squareLogTilt(ratio), tiltTolerance) << "ratio " << ratio;
        EXPECT_NEAR(log.centreHeight, squareLogCentreHeight(ratio), heightTolerance) << "ratio " << ratio;
    }
}

TEST(FloatingLog, ThresholdsAreFound) {
    EXPECT_NEAR(findLogThreshold(0.15, 0.25, 1 * degree), logTiltsFrom, 0.005);
    EXPECT_NEAR(findLogThreshold(0.25, 0.32, 44 * degree), logStandsOnEdgeFrom, 0.005);
}

TEST(FloatingLog, AnswerDoesNotDependOnTheStep) {
    for (const Stepping stepping : {Stepping{1.0 / 30, 1}, Stepping{1.0 / 60, 4}, Stepping{1.0 / 240, 1}})
        EXPECT_NEAR(floatLog(0.26, stepping).tilt, squareLogTilt(0.26), tiltTolerance)
            << stepping.dt << " s in " << stepping.substeps;
}

TEST(FloatingLog, ClosedFormsAgreeWithPublishedValues) {
    // Degrees, from Feigel and Fuzailov 2021 and Gilbert 1991 as tabulated to three decimals.
    const std::pair<double, double> published[] = {{0.22, 13.675}, {0.23, 19.486}, {0.24, 23.485},
                                                   {0.25, 26.565}, {0.26, 29.631}, {0.27, 33.690},
                                                   {0.28, 41.186}};
    for (const auto& [ratio, tilt] : published)
        EXPECT_NEAR(squareLogTilt(ratio) / degree, tilt, 1e-3) << ratio;
}

}  // namespace
}  // namespace bullet_buoyancy::scenes
