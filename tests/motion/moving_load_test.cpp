#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/engine.h"
#include "support/moving_engine.h"
#include "support/near.h"

/// Bodies whose load moves, as that of water in waves does.
namespace bullet_buoyancy::test {
namespace {

constexpr double gravity = 9.8, dt = 1.0 / 60;
constexpr double newton = 1e-3;
constexpr double always = 1e6,
                 never = 0;  // to look ahead: the fastest oscillation that a body is said to have

double randomPower(Random& random, double least, double most) {
    return least * std::pow(most / least, random.uniform(0, 1));
}

/// A ball on a spring of frequency `own` (rad/s) whose place heaves by 1 m at `forced` (rad/s), in the
/// oscillation that is left when all others have died: x = amplitude sin(forced t).
struct ForcedOscillation {
    double own, forced;
    double amplitude = own * own / (own * own - forced * forced);
    Inertia ball = ofBall(2, 0.5);
    Spring spring{ball.mass * own * own};
    MovingEngine engine;

    ForcedOscillation(double itsOwn, double itsForced, double fastest, double step)
        : own(itsOwn), forced(itsForced), engine(ball, spring, heaving(1, itsForced), fastest) {
        Motion start;
        start.velocity.z() = amplitude * forced;
        engine.start(start, step);
    }
    ForcedOscillation(const ForcedOscillation&) = delete;

    double height() const { return amplitude * std::sin(forced * engine.time); }
};

/// In 20 s, m.
double errorOf(double phase, double fastest) {
    const double own = 2, step = phase / own;
    ForcedOscillation it(own, 1, fastest, step);
    double worst = 0;
    while (it.engine.time < 20) {
        it.engine.step(step);
        worst = std::max(worst, std::abs(it.engine.height() - it.height()));
    }
    return worst;
}

/// By one look a step, by the leapfrog that looks ahead (phases below 0.25) and by the trapezoidal rule.
TEST(ForcedOscillation, IsThatOfTheLoadToTheSecondOrderOfTheStep) {
    for (double fastest : {never, always})
        for (double phase : {0.8, 0.2, 0.05}) {
            const double coarse = errorOf(phase, fastest), fine = errorOf(phase / 2, fastest);
            EXPECT_LE(coarse, 0.05 * phase * phase) << fastest << ' ' << phase;
            EXPECT_NEAR(coarse / fine, 4, 0.5) << fastest << ' ' << phase;
        }
}

/// dU/dt at the body's place is -spring (x - place) d(place)/dt, in all
/// -spring (amplitude - 1) sin^2(forced t) / 2.
TEST(ForcedOscillation, TakesTheWorkThatTheLedgerSays) {
    for (double fastest : {never, always}) {
        ForcedOscillation it(2, 1, fastest, dt);
        const double spring = 8, most = spring * (it.amplitude - 1) / 2;
        for (int i = 0; i < 1000; ++i) {
            it.engine.step(dt);
            const EnergyLedger& ledger = it.engine.body.ledger();
            const double sine = std::sin(it.engine.time);
            EXPECT_NEAR(ledger.byWater, -most * sine * sine, most * 4 * dt * dt) << i;
            EXPECT_NEAR(ledger.expected(), it.engine.energy(), 1e-12);
            EXPECT_EQ(ledger.byOthers, 0);
        }
    }
}

TEST(ForcedOscillation, TakesOneEvaluationAStepOrTwoLookingAhead) {
    for (double fastest : {never, always}) {
        ForcedOscillation it(2, 1, fastest, dt);
        for (int i = 0; i < 1000; ++i) {
            const int before = it.engine.body.evaluations();
            it.engine.depart(dt);
            const int ahead = it.engine.body.evaluations() - before;
            it.engine.body.arrive();
            it.engine.time += dt;
            it.engine.settle(dt);
            EXPECT_EQ(ahead + it.engine.body.evaluations(), fastest == never ? 1 : 2);
        }
    }
}

/// Behind or before it by what of its acceleration the spring must give, place'' / own^2, and what Newton's
/// method leaves of a step.
TEST(AVeryLightBody, FollowsItsLoad) {
    for (double phase : {5.0, 10.0, 100.0})
        for (double forced : {2.0, 10.0}) {
            ForcedOscillation it(phase / dt, forced, phase * phase / (dt * dt), dt);
            const double lag = forced * forced * dt * dt / (phase * phase);
            double mostEnergy = 0;
            for (int i = 0; i < 10000; ++i) {
                it.engine.step(dt);
                const double place = it.engine.place(it.engine.time).z();
                ASSERT_NEAR(it.engine.height(), place, lag + newton * forced * dt) << phase << ' ' << i;
                mostEnergy = std::max(mostEnergy, it.engine.energy());
            }
            // The spring's own is a share of forced^2 / own^2, and its speed is the mean of a step.
            const double blurred = forced * forced * dt * dt / 12;
            EXPECT_NEAR(mostEnergy / (it.ball.mass * forced * forced / 2), 1, 2 * newton + lag + blurred)
                << phase;
        }
}

/// The same on a load that ends where the body leaves it, with its weight and with steps of any length, each
/// known only when it is over.
TEST(AVeryLightBody, StaysOnASurfaceThatHeavesWhateverTheSteps) {
    Random random(1);
    for (double mass : {1e-4, 1e-3}) {  // phases from 4 on
        const double lift = 1000, draft = gravity * mass / lift, heave = 0.1, omega = 3;
        const Columns column({Vec3::Zero()}, lift, gravity * mass);
        MovingEngine engine(ofBall(mass, 0.1), column, heaving(heave, omega), lift / mass);
        engine.weight = gravity * mass;
        engine.def.size = 0.1;
        engine.start(stillAt(-draft), dt);
        for (int i = 0; i < 10000; ++i) {
            engine.depart(dt);
            const double step = randomPower(random, 1.0 / 240, 1.0 / 30);
            engine.body.departAgain(engine.inertia, engine.def, engine.loadAt(engine.time + step), step);
            engine.body.arrive();
            engine.time += step;
            engine.settle(step);
            // Where the surface leaves it, by the change of its speed from one step to the next, the body
            // goes on for a step, the longest at most; and what it makes up for in the shortest throws it
            // again.
            const double travel = heave * omega * omega / 30 / 30, speed = 240 * travel;
            ASSERT_NEAR(engine.height() + draft, engine.place(engine.time).z(),
                        travel + speed * speed / (2 * gravity))
                << mass << ' ' << i;
        }
    }
}

/// A box that eight columns carry at its corners, on a place that heaves as the sum of two sines.
struct TossedRaft {
    Vec3 halfSize;
    double mass, lift, step;
    double speed, highest;  // of the place, m/s and m
    Columns field;
    MovingEngine engine;

    static TossedRaft random(Random& random) {
        const double x = random.uniform(0.02, 1), y = random.uniform(0.02, 1);
        const Vec3 half(x, y, random.uniform(0.02, 1));
        const double mass = randomPower(random, 1e-4, 1);
        return TossedRaft(random, half, mass, randomPower(random, 1, 1e4));
    }
    TossedRaft(const TossedRaft&) = delete;

    /// Of its heave in a step, rad.
    double phase() const { return std::sqrt(8 * lift / mass) * step; }

    void start(Random& random) {
        Motion motion = stillAt(halfSize.norm() + highest + random.uniform(0, 0.5));
        motion.pose.orientation = random.orientation();
        motion.setSpin(engine.inertia, random.inCube(2));
        engine.start(motion, step);
    }

private:
    TossedRaft(Random& random, const Vec3& half, double itsMass, double itsLift)
        : halfSize(half),
          mass(itsMass),
          lift(itsLift),
          step(randomPower(random, 1.0 / 240, 1.0 / 30)),
          field(cornersOfBox(half), lift, gravity * itsMass),
          engine(ofBox(itsMass, half), field, heaving(0, 0)) {
        const double a = randomPower(random, 0.01, 1), b = a / 3;
        const double w = randomPower(random, 0.3, 6), v = w * random.uniform(1, 3);
        engine.place = [=](double t) { return Vec3(0, 0, a * std::sin(w * t) + b * std::sin(v * t + 1)); };
        highest = a + b;
        speed = a * w + b * v;
        const Vec3 squares = half.cwiseAbs2();
        const Vec3 turning = 8 * lift * (Vec3::Constant(squares.sum()) - squares);
        engine.def.stiffestRate2 =
            std::max(8 * lift / mass, turning.cwiseProduct(engine.inertia.inversePrincipal).maxCoeff());
        engine.def.size = half.norm();
        engine.weight = gravity * mass;
    }
};

/// With more than two looks ahead a flight is one that the steps do not resolve. Work of the load where the
/// body arrives is told from that where it leaves to half of it.
TEST(ATossedBody, HasNoMoreAfterAnUnresolvedStepThanBeforeAndTheWorkOfItsLoad) {
    Random random(2);
    int unresolved = 0;
    for (int i = 0; i < 300; ++i) {
        TossedRaft raft = TossedRaft::random(random);
        raft.start(random);
        MovingEngine& engine = raft.engine;
        const double scale = engine.energy() + raft.mass * (gravity + raft.speed * raft.speed);
        for (int step = 0; step < 300; ++step) {
            const double before = engine.energy(), held = engine.body.load().potential;
            const Pose from = engine.pose();
            const int looks = engine.body.evaluations();
            engine.depart(raft.step);
            const bool resolved = engine.body.evaluations() - looks <= 2;
            engine.body.arrive();
            engine.time += raft.step;
            engine.settle(raft.step);
            const double work = engine.loadAt(engine.time).at(from).potential - held;
            if (resolved) continue;
            ++unresolved;
            ASSERT_LE(engine.energy(), before + work + std::abs(work) / 2 + newton * scale)
                << i << ' ' << step;
        }
    }
    EXPECT_GT(unresolved, 10000);
}

/// What is thrown up by a floor at its highest speed rises by twice that speed, and comes down on one that
/// may throw it again: thrice. (What the steps resolve keeps on bouncing, and may gain from a floor that
/// moves without end.)
TEST(ATossedBody, NeverFliesFartherThanItsLoadCanThrowIt) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        TossedRaft raft = TossedRaft::random(random);
        if (raft.phase() < 3) continue;
        raft.start(random);
        const double thrown = 9 * raft.speed * raft.speed / (2 * gravity);
        const double ceiling = raft.engine.height() + raft.halfSize.norm() + thrown;
        for (int step = 0; step < 600; ++step) {
            raft.engine.step(raft.step);
            ASSERT_LE(raft.engine.height(), ceiling)
                << i << ' ' << step << ": mass " << raft.mass << ", dt " << raft.step;
        }
    }
}

/// Springs along and about all axes, in a medium that slows the body, at a place that moves along all of
/// them.
TEST(ATossedBody, StaysNearItsPlace) {
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const double mass = randomPower(random, 1e-4, 1), step = randomPower(random, 1.0 / 240, 1.0 / 30);
        Mat6 stiffness = Mat6::Zero();
        const Inertia ball = ofBall(mass, 0.3);
        for (int axis = 0; axis < 6; ++axis)  // at phases from 0.1 to 1000
            stiffness(axis, axis) =
                (axis < 3 ? mass : ball.principal.x()) * std::pow(randomPower(random, 0.1, 1000) / step, 2);
        Spring spring(stiffness);
        spring.medium.dragRate = spring.medium.dampingRate = 1;
        const Vec3 way = random.inCube(1);
        const double omega = randomPower(random, 0.1, 2);
        MovingEngine engine(
            ball, spring, [=](double t) { return Vec3(std::sin(omega * t) * way); },
            stiffness.diagonal().maxCoeff() / std::min(mass, ball.principal.x()));
        engine.start(Motion(), step);
        // To begin with it is at rest and its place is not: it swings by what its slowest spring makes of
        // that, and the drag takes it along behind the place.
        const double slowest = 0.1 / step;
        const double off = 2 * way.norm() * (omega / slowest + omega * (1 + omega) / (slowest * slowest));
        for (int s = 0; s < 2000; ++s) {
            engine.step(step);
            ASSERT_TRUE(isNear(engine.pose().position, engine.place(engine.time),
                               off + 2 * omega * step * way.norm()))
                << i << ' ' << s;
        }
    }
}

/// The leapfrog to rounding, the rest to what Newton's method leaves, which the two ways to begin it need not
/// leave alike.
TEST(ALoadThatIsNotCalmButDoesNotMove, MovesABodyAsACalmOneDoes) {
    for (double phase : {0.1, 0.2, 0.6, 0.9, 3.0, 30.0})
        for (double fastest : {never, phase * phase / (dt * dt)}) {
            if (fastest == never && phase > 0.25) continue;
            const double mass = 2, lift = mass * phase * phase / (dt * dt);
            const Columns column({Vec3::Zero()}, lift, gravity * mass);
            Engine calm(ofBall(mass, 0.5), column, dt, fastest);
            MovingEngine other(ofBall(mass, 0.5), column, heaving(0, 0), fastest);
            const double drop = gravity * mass / lift;  // comes out of it, but only just
            Motion start = stillAt(0);
            start.velocity.x() = 1;
            calm.start(start);
            other.start(start, dt);
            const double tolerance = phase < 0.25 ? 1e-12 : 30 * newton;
            for (int i = 0; i < 100; ++i) {
                calm.step();
                other.step(dt);
                ASSERT_NEAR(calm.height(), other.height(), tolerance * drop) << phase << ' ' << i;
                ASSERT_NEAR(calm.pose().position.x(), other.pose().position.x(), 1e-3 * (i + 1) * dt)
                    << phase;
            }
        }
}

/// Held where it is, the load moves through it: its potential changes, and whoever holds it does nothing.
TEST(AHeldBody, TakesTheWorkOfItsLoadFromTheLoadAlone) {
    const Spring spring(50);
    MovingEngine engine(ofBall(2, 0.5), spring, heaving(1, 2));
    engine.start(stillAt(0), dt);
    const auto hold = [&] {
        engine.depart(dt);
        Disturbance grip;
        grip.velocityChange = -engine.body.departure().velocity;
        engine.body.arriveElsewhere(engine.inertia, engine.pose(), grip);
        engine.time += dt;
        engine.settle(dt);
    };
    for (int i = 0; i < 10; ++i)
        hold();  // until it is known to be held
    const EnergyLedger before = engine.body.ledger();
    const double held = engine.energy();
    for (int i = 0; i < 100; ++i) {
        hold();
        const double place = engine.place(engine.time).z();
        EXPECT_NEAR(engine.energy(), 25 * place * place, 1e-9);
        EXPECT_NEAR(engine.body.ledger().byWater - before.byWater, engine.energy() - held, 1e-9);
        EXPECT_NEAR(engine.body.ledger().byOthers, before.byOthers, 1e-9);
    }
}

/// To the second order of the step: the impulse falls between two poses.
TEST(AStruckBody, HasTheEnergyOfTheBlowFromOthers) {
    const double impulse = 3, mass = 2;
    const Spring spring(50);
    MovingEngine engine(ofBall(mass, 0.5), spring, heaving(1, 2));
    engine.start(stillAt(0), dt);
    for (int i = 0; i < 20; ++i)
        engine.step(dt);
    const double speed = engine.motion().velocity.z();
    engine.depart(dt);
    Disturbance blow;
    blow.velocityChange.z() = impulse / mass;
    Pose pose = engine.body.target();
    pose.position += dt * blow.velocityChange;
    engine.body.arriveElsewhere(engine.inertia, pose, blow);
    engine.time += dt;
    engine.settle(dt);
    const double acceleration = 25 * (1 + engine.height());
    EXPECT_NEAR(engine.body.ledger().byOthers, impulse * (speed + impulse / mass / 2),
                impulse * acceleration * dt);
    EXPECT_NEAR(engine.body.ledger().expected(), engine.energy(), 1e-12);
}

/// The water that was shown ahead is not the one that came.
TEST(ALoadThatJumps, IsEvaluatedAnew) {
    const Spring spring(50);
    for (double fastest : {never, always}) {
        MovingEngine engine(ofBall(2, 0.5), spring, heaving(1, 2), fastest);
        engine.start(stillAt(0), dt);
        engine.step(dt);
        engine.depart(dt);
        engine.time += 0.5;
        engine.body.arrive();
        engine.body.forgetLoadAhead();
        engine.settle(dt);
        EXPECT_EQ(engine.body.load().force, engine.loadAt(engine.time).at(engine.pose()).force);
        EXPECT_NEAR(engine.body.ledger().expected(), engine.energy(), 1e-12);
    }
}

TEST(ALoadThatCalmsDown, HoldsTheBodyToTheEnergyThatItHasThen) {
    for (double phase : {0.1, 0.5, 3.0}) {
        const double mass = 2, lift = mass * phase * phase / (dt * dt);
        const Columns column({Vec3::Zero()}, lift, gravity * mass);
        MovingEngine engine(ofBall(mass, 0.5), column, heaving(0.5, 3), lift / mass);
        engine.weight = gravity * mass;
        engine.start(stillAt(0), dt);
        for (int i = 0; i < 100; ++i)
            engine.step(dt);
        const Vec3 place = engine.place(engine.time);
        BodyMotion& body = engine.body;
        body.depart(engine.inertia, engine.def, engine.loadAt(engine.time), dt);  // it stops here
        // Calm from now on, and shifted so that the place is its zero.
        Motion motion = engine.motion();
        motion.pose.position -= place;
        Engine calm(engine.inertia, column, dt, lift / mass);
        calm.body = body;
        calm.body.arriveElsewhere(engine.inertia, {body.target().position - place, body.target().orientation},
                                  {});
        calm.settle();
        const double energy = calm.energy();
        for (int i = 0; i < 300; ++i) {
            calm.step();
            ASSERT_LE(calm.energy(), energy + newton * std::abs(energy)) << phase << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
