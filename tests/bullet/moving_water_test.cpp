#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "support/bullet_cases.h"

namespace bullet_buoyancy::test {
namespace {

/// Flat, and heaving as a whole: z = amplitude sin(omega t); until it is stilled, at z = 0.
class Tide final : public WaterField {
public:
    Tide(double amplitude, double omega)
        : WaterField(WaterFrame::zUp(), freshWaterDensity), m_amplitude(amplitude), m_omega(omega) {}

    void still() { m_amplitude = 0; }

    double level(double time) const { return m_amplitude * std::sin(m_omega * time); }

    WaterBounds bounds() const override {
        WaterBounds bounds;
        bounds.elevation = m_amplitude;
        bounds.curvatureChange = 0;
        bounds.still = m_amplitude == 0;
        return bounds;
    }
    void sampleSurface(HorizontalPoints, double time, SurfaceSamples samples) const override {
        samples.setZero();
        samples.col(0) = level(time);
    }
    void sampleVelocity(WaterPoints, double time, WaterVelocities velocities) const override {
        velocities.setZero();
        velocities.col(2) = m_amplitude * m_omega * std::cos(m_omega * time);
    }

private:
    double m_amplitude, m_omega;
};

class Harbour {
public:
    Tide tide;
    BuoyancyAction buoyancy{tide};
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

    Harbour(double amplitude, double omega) : tide(amplitude, omega) {
        world.setGravity({0, 0, btScalar(-standardGravity)});
        world.addAction(&buoyancy);
    }
    ~Harbour() {
        world.removeAction(&buoyancy);
        for (const auto& body : m_bodies)
            world.removeRigidBody(body.get());
    }
    Harbour(const Harbour&) = delete;

    btRigidBody& add(const Vec3& size, double mass, double height) {
        m_shapes.push_back(std::make_unique<btBoxShape>(toBullet(size / 2)));
        btVector3 inertia(0, 0, 0);
        if (mass > 0) m_shapes.back()->calculateLocalInertia(btScalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, m_shapes.back().get(),
                                                      inertia);
        info.m_startWorldTransform = toTransform(at({0, 0, height}));
        m_bodies.push_back(std::make_unique<btRigidBody>(info));
        world.addRigidBody(m_bodies.back().get());
        return *m_bodies.back();
    }

    /// Of a ratio of its density to the water's.
    btRigidBody& addFloating(const Vec3& size, double ratio, double height, const BodyDef& def = {}) {
        btRigidBody& body = add(size, ratio * freshWaterDensity * size.prod(), height);
        EXPECT_TRUE(buoyancy.addBody(body, def));
        return body;
    }

    void step(double seconds = dt) { world.stepSimulation(btScalar(seconds), 0); }
    void run(double seconds) {
        for (long i = std::lround(seconds / dt); i > 0; --i)
            step();
    }

private:
    std::vector<std::unique_ptr<btCollisionShape>> m_shapes;
    std::vector<std::unique_ptr<btRigidBody>> m_bodies;
};

double heightOf(const btRigidBody& body) {
    return double(body.getWorldTransform().getOrigin().z());
}

BodyDef frictionless() {
    BodyDef def;
    def.linearDrag = def.angularDamping = 0;
    return def;
}

/// x'' = own^2 (level - x), from rest at x = 0: forced and own oscillation together.
double answer(double own, double omega, double amplitude, double time) {
    const double forced = own * own / (own * own - omega * omega);
    return amplitude * forced * (std::sin(omega * time) - omega / own * std::sin(own * time));
}

/// To the second order of the step, of 600 of them at a phase that the leapfrog advances by phase^2 / 24 too
/// much, and what Bullet's first step is off by.
TEST(InATide, ASlabHeavesAsItsClosedFormSays) {
    const double amplitude = 0.1, omega = 0.7, own = std::sqrt(standardGravity / 0.5);
    Harbour harbour(amplitude, omega);
    btRigidBody& slab = harbour.addFloating({2, 2, 1}, 0.5, 0, frictionless());
    const double phase = own * dt, ofOwn = amplitude * omega / own;
    for (int i = 1; i <= 600; ++i) {
        harbour.step();
        if (i == 1) continue;  // Bullet's body is where gravity alone took it
        const double time = i * dt;
        ASSERT_NEAR(
            heightOf(slab), answer(own, omega, amplitude, time),
            ofOwn * i * phase * phase * phase / 24 + amplitude * omega * omega * dt * dt + 600 * poseRounding)
            << i;
    }
}

/// The ledger closes to what the guard of its energy takes: nothing, of a motion that is resolved.
TEST(InATide, TheWaterMovesASlabAndTheLedgerSaysSo) {
    Harbour harbour(0.1, 0.7);
    btRigidBody& slab = harbour.addFloating({2, 2, 1}, 0.5, 0);
    double most = 0;
    for (int i = 0; i < 600; ++i) {
        harbour.step();
        const BodyReport report = harbour.buoyancy.report(slab);
        const double scale = 2000 * standardGravity * 0.1;
        ASSERT_NEAR(report.energy.expected(), report.totalEnergy(), 600 * poseRounding * scale);
        ASSERT_EQ(report.energy.byOthers, 0);
        most = std::max(most, report.energy.byWater);
    }
    EXPECT_GT(most, 100);
}

/// In a tide of one period a minute its draft is that at rest but for its acceleration, over g, and the
/// drag's hold.
TEST(InATide, ACubeKeepsItsDraftWhileTheTideIsSlow) {
    const double omega = 0.1, amplitude = 2;
    Harbour harbour(amplitude, omega);
    btRigidBody& raft = harbour.addFloating({2, 2, 1}, 0.5, 0);
    raft.setLinearVelocity({0, 0, btScalar(amplitude * omega)});
    for (int i = 0; i < 7200; ++i) {
        harbour.step();
        if (i < 600) continue;  // its own oscillation dies by e^-0.75 a second
        const double level = harbour.tide.level(harbour.buoyancy.time());
        ASSERT_NEAR(heightOf(raft) - level, 0, 1.1 * amplitude * omega * omega / standardGravity * 0.5) << i;
    }
}

/// Closer than a tenth of its size, on water that rises by more than its size in four steps.
TEST(InATide, FoamRidesTheWaterAndNeverFlies) {
    for (double ratio : {1e-3, 1e-2})
        for (const BodyDef& def : {BodyDef{}, frictionless()}) {
            const double size = 0.05, amplitude = 0.5, omega = 2;
            Harbour harbour(amplitude, omega);
            btRigidBody& foam = harbour.addFloating({size, size, size}, ratio, size / 2, def);
            foam.setLinearVelocity({0, 0, btScalar(amplitude * omega)});
            long evaluations = 0;
            for (int i = 0; i < 3600; ++i) {
                harbour.step();
                evaluations += harbour.buoyancy.report(foam).evaluations;
                const double draft = heightOf(foam) - harbour.tide.level(harbour.buoyancy.time());
                ASSERT_GT(draft, 0.4 * size) << ratio << ' ' << i;
                ASSERT_LT(draft, 0.6 * size) << ratio << ' ' << i;
            }
            EXPECT_LT(evaluations, 3600 * 8);
        }
}

/// As steep a tide as throws it off, whose fall outruns gravity: what it is thrown with is the water's speed,
/// and its own fall onto it. (What the steps resolve bounces, and may bounce higher
/// yet.)
TEST(InATide, FoamThatTheWaterThrowsComesBack) {
    for (double size : {0.05, 0.3})
        for (double ratio : {1e-4, 1e-3}) {
            const double amplitude = 0.5, omega = 6, speed = amplitude * omega;
            Harbour harbour(amplitude, omega);
            btRigidBody& foam = harbour.addFloating({size, size, size}, ratio, size / 2);
            foam.setLinearVelocity({0, 0, btScalar(speed)});
            const double ceiling = amplitude + size + 9 * speed * speed / (2 * standardGravity);
            for (int i = 0; i < 3600; ++i) {
                harbour.step();
                ASSERT_LT(heightOf(foam), ceiling) << size << ' ' << ratio << ' ' << i;
                ASSERT_GT(heightOf(foam), -amplitude - size) << size << ' ' << ratio << ' ' << i;
            }
        }
}

/// To the second order of the step; and where Bullet could not know its length no one else has done anything.
TEST(InATide, StepsOfAnyLengthAgree) {
    Harbour steady(0.1, 0.7), varied(0.1, 0.7);
    btRigidBody& a = steady.addFloating({2, 2, 1}, 0.5, 0);
    btRigidBody& b = varied.addFloating({2, 2, 1}, 0.5, 0);
    for (int i = 0; i < 300; ++i) {
        for (int j = 0; j < 3; ++j)
            steady.step(dt / 2);
        varied.step(dt);
        varied.step(dt / 2);
        ASSERT_EQ(varied.buoyancy.report(b).energy.byOthers, 0);
    }
    EXPECT_NEAR(varied.buoyancy.time(), steady.buoyancy.time(), 900 * poseRounding);
    EXPECT_NEAR(heightOf(a), heightOf(b), 1e-3);
}

TEST(InATide, TheReportIsThatOfTheEvaluatorAtTheTimeOfThePose) {
    Harbour harbour(0.3, 2);
    btRigidBody& light = harbour.addFloating({0.3, 0.3, 0.3}, 0.02, 0.15);
    btRigidBody& heavy = harbour.addFloating({2, 2, 1}, 0.5, 0);
    light.getWorldTransform().setOrigin({5, 0, btScalar(0.15)});
    harbour.run(2);
    for (const btRigidBody* body : {&light, &heavy}) {
        const BodyReport report = harbour.buoyancy.report(*body);
        HydrostaticQuery query;
        query.time = harbour.buoyancy.time();
        BodyDef def;
        const auto hull = hullFromShape(*body->getCollisionShape()).hull;
        const HydrostaticResult expected =
            evaluateExact(*hull, toPose(body->getWorldTransform()), harbour.tide, query);
        const double scale = 1 / double(body->getInvMass()) * standardGravity;
        EXPECT_LT((toEigen(report.forceWorld) - expected.forceWorld).norm(), 100 * poseRounding * scale * 50);
        EXPECT_NEAR(report.submergedVolume, expected.submergedVolume, 100 * poseRounding);
        EXPECT_EQ(report.forceErrorBound, expected.forceErrorBound);
        EXPECT_GE(report.waterSamples, 0);
    }
}

/// Where it was shown the water that follows, and where it was not.
TEST(TheTime, CanBeReadAndSet) {
    for (double ratio : {0.5, 0.01}) {
        Harbour harbour(0.2, 1);
        EXPECT_EQ(harbour.buoyancy.time(), 0);
        btRigidBody& raft = harbour.addFloating({0.5, 0.5, 0.2}, ratio, 0.1 - 0.2 * ratio);
        harbour.run(1);
        EXPECT_NEAR(harbour.buoyancy.time(), 1, 60 * poseRounding);
        harbour.buoyancy.setTime(pi / 2 - dt);
        EXPECT_EQ(harbour.buoyancy.time(), pi / 2 - dt);
        harbour.step();
        EXPECT_NEAR(harbour.buoyancy.time(), pi / 2, poseRounding * 10);
        const BodyReport report = harbour.buoyancy.report(raft);
        const double depth = 0.2 - (heightOf(raft) - 0.1);
        EXPECT_NEAR(report.submergedVolume, 0.25 * std::min(0.2, depth), 1e-4) << ratio;
        EXPECT_NEAR(report.energy.expected(), report.totalEnergy(), 1e-3 * std::abs(report.totalEnergy()));
        harbour.run(1);
        EXPECT_LT(heightOf(raft), 0.2 + 0.5) << ratio;  // it was not thrown
    }
}

/// Beyond its reach it is not even touched.
TEST(Sleep, AboveTheHighestTideIsNotDisturbed) {
    Harbour harbour(0.5, 1);
    harbour.add({10, 10, 1}, 0, 0.5);  // a quay; its top is at 1 m
    btRigidBody& crate = harbour.addFloating({1, 1, 1}, 0.5, 2.5);
    harbour.run(20);
    ASSERT_FALSE(crate.isActive());
    const btTransform asleep = crate.getWorldTransform();
    harbour.run(20);
    EXPECT_FALSE(crate.isActive());
    EXPECT_EQ(crate.getWorldTransform(), asleep);
    EXPECT_EQ(harbour.buoyancy.report(crate).state, BodyState::asleep);
}

/// Wet or not, at the moment.
TEST(Sleep, DoesNotComeWithinTheReachOfTheTide) {
    Harbour harbour(0.5, 0.2);
    harbour.add({10, 10, 1}, 0, -0.4);  // a slip whose top is at 0.1 m
    btRigidBody& crate = harbour.addFloating({1, 1, 1}, 2, 0.6);
    harbour.run(5);
    bool wasDry = false, wasWet = false;
    for (int i = 0; i < 3600; ++i) {
        harbour.step();
        const BodyState state = harbour.buoyancy.report(crate).state;
        wasDry = wasDry || state == BodyState::dry;
        wasWet = wasWet || state == BodyState::floating;
        ASSERT_TRUE(crate.isActive()) << i;
        ASSERT_NE(state, BodyState::asleep) << i;
    }
    EXPECT_TRUE(wasDry && wasWet);
}

TEST(Sleep, EndsWhereTheTideMayReach) {
    Harbour harbour(0.5, 0.2);
    btRigidBody& raft = harbour.addFloating({2, 2, 1}, 0.5, 0);
    harbour.step();
    raft.forceActivationState(ISLAND_SLEEPING);
    harbour.step();
    EXPECT_TRUE(raft.isActive());
}

TEST(Sleep, ComesWhenTheTideIsOver) {
    Harbour harbour(0.1, 1);
    btRigidBody& raft = harbour.addFloating({2, 2, 1}, 0.5, 0);
    btRigidBody& foam = harbour.addFloating({0.3, 0.3, 0.1}, 0.02, 0.05);
    foam.getWorldTransform().setOrigin({5, 0, btScalar(0.05)});
    harbour.run(60);
    EXPECT_TRUE(raft.isActive() && foam.isActive());
    harbour.tide.still();
    harbour.run(60);
    EXPECT_FALSE(raft.isActive());
    EXPECT_FALSE(foam.isActive());
    EXPECT_NEAR(heightOf(raft), 0, 1e-3);
}

class HighestEnds : public btIDebugDraw {
public:
    std::vector<double> heights;

    void drawLine(const btVector3& from, const btVector3& to, const btVector3&) override {
        heights.push_back(std::max(double(from.z()), double(to.z())));
    }
    void drawSphere(const btVector3&, btScalar, const btVector3&) override {}
    void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
    void reportErrorWarning(const char*) override {}
    void draw3dText(const btVector3&, const char*) override {}
    void setDebugMode(int) override {}
    int getDebugMode() const override { return DBG_DrawWireframe; }
};

TEST(DebugDraw, ShowsTheWaterlineOfTheMoment) {
    Harbour harbour(0.2, 1);
    btRigidBody& pile = harbour.addFloating({1, 1, 4}, 3, 0);
    pile.setGravity({0, 0, 0});
    pile.setLinearFactor({0, 0, 0});
    harbour.run(1);
    HighestEnds lines;
    harbour.buoyancy.debugDraw(&lines);
    ASSERT_GT(lines.heights.size(), 1u);
    lines.heights.pop_back();  // the arrow of the force
    EXPECT_NEAR(*std::max_element(lines.heights.begin(), lines.heights.end()),
                harbour.tide.level(harbour.buoyancy.time()), 10 * poseRounding);
}

}  // namespace
}  // namespace bullet_buoyancy::test
