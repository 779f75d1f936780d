#include "scenes/free_spin.h"

#include <LinearMath/btScalar.h>
#include <gtest/gtest.h>

namespace bullet_buoyancy::scenes {
namespace {

/// The momentum is reported in Bullet's precision: some 1e-7 in single. In double what counts is that the
/// water's torques cancel to 1e-16 of their parts, while the momentum falls to 5e-5 of its start.
constexpr double readingError = sizeof(btScalar) == 4 ? 5e-6 : 1e-10;

TEST(FreeSpin, MomentumKeepsItsLengthAndAxisWithoutDamping) {
    SpinDef def;
    def.dampingRate = 0;
    const SpinError error = spinError(spinFreely(def, SpinOwner::library), 0);
    EXPECT_LT(error.length, readingError);
    EXPECT_LT(error.angle, readingError);
}

TEST(FreeSpin, DampingIsExponentialAtAnyStep) {
    SpinDef def;
    def.dampingRate = 0.5;
    for (double dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
        const SpinError error = spinError(spinFreely(def, SpinOwner::library, {dt, 1}), def.dampingRate);
        EXPECT_LT(error.length, readingError) << dt;
        EXPECT_LT(error.angle, readingError) << dt;
    }
}

TEST(FreeSpin, BulletsOwnDampedVelocityDoesWorse) {
    const SpinDef def;
    const SpinError ours = spinError(spinFreely(def, SpinOwner::library), def.dampingRate);
    const SpinError bullets = spinError(spinFreely(def, SpinOwner::bullet), def.dampingRate);
    EXPECT_GT(bullets.length, 100 * ours.length);
    EXPECT_GT(bullets.angle, 100 * ours.angle);
}

}  // namespace
}  // namespace bullet_buoyancy::scenes
