#include <gtest/gtest.h>

#include <cmath>

#include "support/engine.h"
#include "support/near.h"
#include "support/simple_loads.h"

/// Bodies that contacts and joints hold or strike.
namespace bullet_buoyancy::test {
namespace {

constexpr double dt = 1.0 / 60, gravity = 9.8;

/// However strong the drag: what it holds a body back by, the ground carries.
TEST(HeldBody, PressesWithItsWholeLoad) {
    for (double rate : {0.0, 0.5, 3.0, 30.0}) {
        Weight sea(2 * gravity);
        sea.medium.dragRate = rate;
        Engine engine(ofBall(2, 0.5), sea, dt);
        engine.start(stillAt(0));
        for (int i = 0; i < 100; ++i)
            engine.hold();
        engine.depart();
        EXPECT_NEAR(engine.body.departure().velocity.z(), -gravity * dt, 1e-12) << rate;
        EXPECT_DOUBLE_EQ(engine.body.linearRelief(), 1) << rate;
    }
}

TEST(HeldBody, TurnsAgainstItsHoldWithItsWholeTorque) {
    Mat6 stiffness = Mat6::Zero();
    stiffness(3, 3) = 5;
    Spring spring(stiffness);
    spring.medium.dampingRate = 3;
    Engine engine(ofBall(2, 0.5), spring, dt);
    Motion start;
    start.pose.orientation = Eigen::AngleAxisd(0.3, Vec3::UnitX());
    engine.start(start);
    for (int i = 0; i < 100; ++i)
        engine.hold();
    engine.depart();
    EXPECT_TRUE(isNear(engine.body.departure().momentum, Vec3(-5 * 0.3 * dt, 0, 0), 1e-12));
    EXPECT_DOUBLE_EQ(engine.body.angularRelief(), 1);
}

TEST(HeldBody, LetGoFallsWithItsDragAgain) {
    Weight sea(2 * gravity);
    sea.medium.dragRate = 3;
    Engine engine(ofBall(2, 0.5), sea, dt);
    engine.start(stillAt(0));
    for (int i = 0; i < 10; ++i)
        engine.hold();
    engine.steps(600);
    EXPECT_EQ(engine.body.linearRelief(), 0);
    EXPECT_NEAR(engine.motion().velocity.z(), -gravity / 3, 1e-9);
}

TEST(HeldBody, HasNoEnergyOfItsHold) {
    Weight sea(2 * gravity);
    Engine engine(ofBall(2, 0.5), sea, dt);
    engine.start(stillAt(0));
    for (int i = 0; i < 100; ++i) {
        engine.hold();
        EXPECT_EQ(engine.pose().position, Vec3::Zero());
        EXPECT_NEAR(engine.body.ledger().expected(), engine.energy(), 1e-12);
    }
}

/// A blow lasts but one step, and is no hold.
TEST(HeldBody, IsNotOneThatWasStruck) {
    Weight sea(2 * gravity);
    Engine engine(ofBall(2, 0.5), sea, dt);
    engine.start(stillAt(0));
    engine.step({0, 0, 100});
    EXPECT_EQ(engine.body.linearRelief(), 0);
    engine.step();
    EXPECT_EQ(engine.body.linearRelief(), 0);
}

/// A ball much lighter than the water that it is held under, by a hold that stops all motion.
struct LightBall {
    double size = 0.05, mass;
    Columns column;
    Engine engine;

    LightBall(double itsMass, double depth)
        : mass(itsMass),
          column({Vec3::Zero()}, 100, gravity * mass),
          engine(ofBall(mass, size), column, dt, 100 / mass) {
        engine.def.size = size;
        engine.start(stillAt(-depth));
        for (int i = 0; i < 10; ++i)
            engine.hold();
    }
    LightBall(const LightBall&) = delete;
};

/// Its load along its own size is the most that it may be thrown with.
TEST(HeldBody, LetGoUnderWaterIsNotThrownFartherThanItsSizeAllows) {
    for (double mass : {1e-4, 1e-3, 1e-2, 1e-1}) {
        LightBall ball(mass, 0.05);
        const double load = 100 * 0.05 - gravity * mass, held = ball.engine.body.load().potential;
        ball.engine.step();
        EXPECT_LE(ball.engine.energy(), held * (1 + 1e-9)) << mass;
        EXPECT_LE(ball.engine.height() + 0.05, std::sqrt(2 * load / mass * ball.size) * dt * (1 + 1e-9))
            << mass;
        EXPECT_GT(ball.engine.height(), -0.05) << mass;
    }
}

/// The speed that the load gives along the size.
TEST(HeldBody, OfLittleMassIsNotPressedAsItsWholeLoadWould) {
    for (double mass : {1e-4, 1e-3}) {
        LightBall ball(mass, 0.05);
        const double acceleration = 100 * 0.05 / mass - gravity;
        ball.engine.depart();
        const double kick = ball.engine.body.departure().velocity.z() - ball.engine.motion().velocity.z();
        EXPECT_NEAR(kick / std::sqrt(2 * acceleration * ball.size), 1, 1e-12);
        EXPECT_LT(kick, acceleration * dt);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
