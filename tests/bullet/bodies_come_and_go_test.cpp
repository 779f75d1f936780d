#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/float_scene.h"
#include "support/bullet_cases.h"

namespace bullet_buoyancy::test {
namespace {

using scenes::FloatScene;
using scenes::heightAboveWater;
using scenes::SceneDef;

constexpr double shapeRounding = 1e-6;  // of the coordinates of shapes, in single precision

BodyDef frictionless() {
    BodyDef def;
    def.linearDrag = def.angularDamping = 0;
    return def;
}

std::unique_ptr<btBoxShape> box(double x, double y, double z) {
    return std::make_unique<btBoxShape>(toBullet(Vec3(x, y, z) / 2));
}

/// Bullet, too, remembers pairs of shapes.
void swapShape(btDynamicsWorld& world, btRigidBody& body, btCollisionShape* shape) {
    body.setCollisionShape(shape);
    if (body.getBroadphaseHandle())
        world.getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(body.getBroadphaseHandle(),
                                                                              world.getDispatcher());
}

TEST(UpdateHull, ABodyFloatsAtTheDraftOfItsNewShape) {
    FloatScene scene;
    auto former = box(2, 2, 1);
    btRigidBody& raft = scene.addBody(box(2, 2, 1), 2000, at({0, 0, 0}));
    btCollisionShape* const ofScene = raft.getCollisionShape();
    raft.setCollisionShape(former.get());
    ASSERT_TRUE(scene.buoyancy().addBody(raft));
    scene.run(10, dt);
    EXPECT_NEAR(heightAboveWater(raft, scene.water()), 0, 1e-3);

    const auto larger = box(4, 4, 1);
    swapShape(scene.world(), raft, larger.get());
    EXPECT_TRUE(scene.buoyancy().report(raft).shapeHasChanged);
    EXPECT_TRUE(scene.buoyancy().updateHull(raft));
    former.reset();
    EXPECT_FALSE(scene.buoyancy().report(raft).shapeHasChanged);
    scene.run(60, dt);
    EXPECT_NEAR(heightAboveWater(raft, scene.water()), 0.5 - 2. / 16, 1e-4);
    swapShape(scene.world(), raft, ofScene);
}

TEST(UpdateHull, TakesAScaledShape) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    scene.step(dt);
    raft.getCollisionShape()->setLocalScaling({2, 2, 1});
    EXPECT_TRUE(scene.buoyancy().report(raft).shapeHasChanged);
    ASSERT_TRUE(scene.buoyancy().updateHull(raft));
    scene.run(60, dt);
    EXPECT_NEAR(scene.buoyancy().report(raft).wetFraction, 0.5 / 4, 1e-5);
    EXPECT_NEAR(scene.buoyancy().report(raft).submergedVolume, 2, 1e-4);
}

/// Which no one sees from outside.
TEST(UpdateHull, TakesACompoundWithAnotherChildForAllBodiesThatHaveIt) {
    FloatScene scene;
    auto compound = std::make_unique<btCompoundShape>();
    btCompoundShape& shape = *compound;
    const auto child = box(1, 1, 1);
    for (double side : {-1.0, 1.0})
        shape.addChildShape(btTransform(btQuaternion::getIdentity(), toBullet(Vec3(2 * side, 0, 0))),
                            child.get());
    btRigidBody& one = scene.addBody(std::move(compound), 1000, at({0, 0, -20}));
    btRigidBody& two = scene.addBody(box(1, 1, 1), 1000, at({0, 30, -20}));
    btCollisionShape* const twos = two.getCollisionShape();
    two.setCollisionShape(&shape);
    for (btRigidBody* body : {&one, &two})
        ASSERT_TRUE(scene.buoyancy().addBody(*body));
    scene.step(dt);
    EXPECT_NEAR(scene.buoyancy().report(one).submergedVolume, 2, 2 * shapeRounding);

    for (double side : {-1.0, 1.0})
        shape.addChildShape(btTransform(btQuaternion::getIdentity(), toBullet(Vec3(0, 2 * side, 0))),
                            child.get());
    for (btRigidBody* body : {&one, &two})
        ASSERT_TRUE(scene.buoyancy().updateHull(*body));
    scene.step(dt);
    for (const btRigidBody* body : {&one, &two})
        EXPECT_NEAR(scene.buoyancy().report(*body).submergedVolume, 4, 4 * shapeRounding);
    swapShape(scene.world(), two, twos);
}

TEST(UpdateHull, TakesAHullOfTheUsers) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    ASSERT_TRUE(scene.buoyancy().updateHull(raft, hullFromShape(*box(2, 2, 4)).hull));
    scene.run(60, dt);
    EXPECT_NEAR(scene.buoyancy().report(raft).wetFraction, 0.5 / 4, 1e-5);
}

TEST(UpdateHull, RefusesAndLeavesTheBodyAsItWas) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    btRigidBody& stranger = scene.addBody(box(1, 1, 1), 500, at({5, 0, 0}));
    EXPECT_EQ(scene.buoyancy().updateHull(stranger).error, BodyError::notAdded);
    EXPECT_EQ(scene.buoyancy().updateHull(raft, std::make_shared<Hull>()).error, BodyError::badHull);
    btCollisionShape* const shape = raft.getCollisionShape();
    btStaticPlaneShape plane({0, 0, 1}, 0);
    raft.setCollisionShape(&plane);
    EXPECT_EQ(scene.buoyancy().updateHull(raft).error, BodyError::badHull);
    raft.setCollisionShape(nullptr);
    EXPECT_EQ(scene.buoyancy().updateHull(raft).error, BodyError::noShape);
    raft.setCollisionShape(shape);
    scene.run(60, dt);
    EXPECT_NEAR(scene.buoyancy().report(raft).wetFraction, 0.5, 1e-4);
}

TEST(UpdateHull, WakesTheBody) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    scene.step(dt);
    raft.forceActivationState(ISLAND_SLEEPING);
    raft.getCollisionShape()->setLocalScaling({2, 2, 1});
    ASSERT_TRUE(scene.buoyancy().updateHull(raft));
    EXPECT_TRUE(raft.isActive());
}

/// Under water, where no shape is turned by the water's pressure about its own centre.
TEST(UpdateHull, KeepsTheAngularMomentumAndTheVelocity) {
    FloatScene scene;
    btRigidBody& top = scene.addFloatingBox({1, 2, 3}, 1, at({0, 0, -50}), frictionless());
    top.setAngularVelocity({2, 1, btScalar(0.5)});
    top.setLinearVelocity({1, 0, 0});
    scene.run(1, dt);
    const BodyReport before = scene.buoyancy().report(top);
    top.getCollisionShape()->setLocalScaling({2, 1, btScalar(0.5)});  // of the same volume
    ASSERT_TRUE(scene.buoyancy().updateHull(top));
    scene.run(1, dt);
    const BodyReport after = scene.buoyancy().report(top);
    const double momentum = double(before.angularMomentum.length());
    EXPECT_NEAR(double((after.angularMomentum - before.angularMomentum).length()), 0, 1e-5 * momentum);
    EXPECT_NEAR(double(after.velocity.x()), 1, 1e-5);
}

/// Lifting more of a body out of the water is work, and so is pushing more of it under.
TEST(UpdateHull, TheLedgerKnowsWhoseWorkItIs) {
    for (double factor : {0.5, 2.0}) {
        FloatScene scene;
        btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0.1}), frictionless());
        scene.run(1, dt);
        const BodyReport before = scene.buoyancy().report(raft);
        EXPECT_EQ(before.energy.byOthers, 0);
        raft.getCollisionShape()->setLocalScaling({btScalar(factor), 1, 1});
        ASSERT_TRUE(scene.buoyancy().updateHull(raft));
        scene.step(dt);
        const BodyReport after = scene.buoyancy().report(raft);
        // The potential of what is wet grows with the waterplane.
        EXPECT_NEAR(after.energy.byOthers, (factor - 1) * before.waterPotentialEnergy,
                    0.1 * before.waterPotentialEnergy);
        const double stiffness = 4000 * factor * standardGravity, farthest = 0.6;
        const double ofMotion = stiffness * farthest * farthest / 2, phase2 = stiffness / 2000 * dt * dt;
        double most = after.totalEnergy();
        for (int i = 0; i < 600; ++i) {
            scene.step(dt);
            const BodyReport report = scene.buoyancy().report(raft);
            most = std::max(most, report.totalEnergy());
            ASSERT_NEAR(report.totalEnergy(), report.energy.expected(), ofMotion * phase2) << i;
        }
        EXPECT_LE(most, after.energy.expected() + 1e-6 * std::abs(after.energy.expected()));
    }
}

/// Those that are pushed off the world's edge are removed by many a game before the action hears of it.
TEST(RemoveBody, MayComeAfterTheBodyHasLeftTheWorld) {
    FloatScene scene;
    btRigidBody& raft = scene.addFloatingBox({2, 2, 1}, 0.5, at({0, 0, 0}));
    raft.setDamping(0, btScalar(0.3));
    scene.run(0.5, dt);
    scene.world().removeRigidBody(&raft);
    scene.run(0.1, dt);
    EXPECT_TRUE(scene.buoyancy().removeBody(raft));
    EXPECT_EQ(raft.getAngularDamping(), btScalar(0.3));
    scene.run(0.1, dt);
    scene.world().addRigidBody(&raft);
}

/// Bodies and shapes at random, with all that befalls them in a game.
class Traffic {
public:
    Traffic(unsigned seed, double flow) : m_scene(inCurrent(flow)), m_random(seed) {
        m_scene.world().setInternalTickCallback(
            [](btDynamicsWorld* world, btScalar) {
                static_cast<Traffic*>(world->getWorldUserInfo())->beforeTick();
            },
            this, true);
        m_scene.world().setInternalTickCallback(
            [](btDynamicsWorld* world, btScalar) {
                static_cast<Traffic*>(world->getWorldUserInfo())->inTick();
            },
            this, false);
    }
    ~Traffic() {
        while (!m_bodies.empty())
            remove(m_bodies.size() - 1);
    }
    Traffic(const Traffic&) = delete;
    Traffic& operator=(const Traffic&) = delete;

    void run(int calls) {
        for (int i = 0; i < calls; ++i) {
            act();
            m_scene.step(3. / 64, 3);
            expectSense();
        }
    }

    int actions() const { return m_actions; }
    int inTicks() const { return m_inTicks; }

private:
    struct Floating {
        std::shared_ptr<btCollisionShape> shape;  // may be others', too
        std::unique_ptr<btRigidBody> body;
        double volume = 0;    // of the shape that the action was last told of
        bool isFresh = true;  // the action has not stepped it with that shape
        bool isInWorld = true;
    };

    static SceneDef inCurrent(double flow) {
        SceneDef def;
        def.flowVelocityWorld = {flow, 0, 0};
        return def;
    }

    double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }

    void beforeTick() {
        for (Floating& floating : m_bodies)
            floating.isFresh = floating.isFresh && !floating.isInWorld;
        inTick();
    }

    void inTick() {
        if (below(4) != 0) return;
        act();
        ++m_inTicks;
    }

    void act() {
        ++m_actions;
        const std::size_t what = m_bodies.size() < 4 ? 0 : below(11);
        if (what <= 1 && m_bodies.size() < 30) return add();
        if (m_bodies.empty()) return;
        const std::size_t which = below(m_bodies.size());
        Floating& floating = m_bodies[which];
        switch (what) {
            case 2:
                return remove(which);
            case 3:
                return swap(floating, anyShape());
            case 4:
                return swap(floating, m_bodies[below(m_bodies.size())].shape);
            case 5:
                return scale(floating);
            case 6:
                return leaveOrReturn(floating);
            case 7:
                return reweigh(floating);
            case 8:
                return readd(floating);
            case 9:
                return restore();
            default:
                return push(floating);
        }
    }

    std::shared_ptr<btCollisionShape> anyShape() {
        switch (below(4)) {
            case 0:
                return std::make_shared<btSphereShape>(btScalar(uniform(0.2, 0.7)));
            case 1:
                return std::make_shared<btCapsuleShapeZ>(btScalar(uniform(0.2, 0.5)),
                                                         btScalar(uniform(0.3, 1)));
            default:
                return box(uniform(0.3, 1.5), uniform(0.3, 1.5), uniform(0.3, 1.5));
        }
    }

    static double volumeOf(const btCollisionShape& shape) {
        return hullFromShape(shape).hull->moments.volume;
    }

    void add() {
        Floating floating;
        const bool isShared = !m_bodies.empty() && below(3) == 0;
        floating.shape = isShared ? m_bodies[below(m_bodies.size())].shape : anyShape();
        floating.volume = volumeOf(*floating.shape);
        floating.isFresh = true;
        const double mass = uniform(0.05, 1.3) * freshWaterDensity * floating.volume;
        btVector3 inertia;
        floating.shape->calculateLocalInertia(btScalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, floating.shape.get(), inertia);
        info.m_startWorldTransform.setIdentity();
        info.m_startWorldTransform.setOrigin(toBullet({uniform(-6, 6), uniform(-6, 6), uniform(-3, 3)}));
        floating.body = std::make_unique<btRigidBody>(info);
        m_scene.world().addRigidBody(floating.body.get());
        EXPECT_TRUE(m_scene.buoyancy().addBody(*floating.body, frictionless()));
        m_bodies.push_back(std::move(floating));
    }

    /// From the world before the action, or after it.
    void remove(std::size_t which) {
        Floating& floating = m_bodies[which];
        const bool worldFirst = below(2) == 0;
        if (worldFirst && floating.isInWorld) m_scene.world().removeRigidBody(floating.body.get());
        EXPECT_TRUE(m_scene.buoyancy().removeBody(*floating.body));
        if (!worldFirst && floating.isInWorld) m_scene.world().removeRigidBody(floating.body.get());
        m_bodies.erase(m_bodies.begin() + std::ptrdiff_t(which));
    }

    /// The former shape is deleted at once if no one else has it.
    void swap(Floating& floating, std::shared_ptr<btCollisionShape> shape) {
        swapShape(m_scene.world(), *floating.body, shape.get());
        floating.shape = std::move(shape);
        update(floating);
    }

    void scale(Floating& floating) {
        for (Floating& other : m_bodies)
            if (other.shape == floating.shape) swapShape(m_scene.world(), *other.body, other.shape.get());
        const auto factor = btScalar(uniform(0.5, 1.5));
        floating.shape->setLocalScaling({factor, factor, factor});
        for (Floating& other : m_bodies)
            if (other.shape == floating.shape) update(other);
    }

    void update(Floating& floating) {
        EXPECT_TRUE(m_scene.buoyancy().updateHull(*floating.body));
        floating.volume = volumeOf(*floating.shape);
        floating.isFresh = true;
    }

    void leaveOrReturn(Floating& floating) {
        if (floating.isInWorld)
            m_scene.world().removeRigidBody(floating.body.get());
        else
            m_scene.world().addRigidBody(floating.body.get());
        floating.isInWorld = !floating.isInWorld;
    }

    void reweigh(Floating& floating) {
        const double mass = uniform(0.05, 1.3) * freshWaterDensity * floating.volume;
        btVector3 inertia;
        floating.shape->calculateLocalInertia(btScalar(mass), inertia);
        floating.body->setMassProps(btScalar(mass), inertia);
        floating.body->updateInertiaTensor();
    }

    void readd(Floating& floating) {
        EXPECT_TRUE(m_scene.buoyancy().removeBody(*floating.body));
        EXPECT_FALSE(m_scene.buoyancy().removeBody(*floating.body));
        EXPECT_TRUE(m_scene.buoyancy().addBody(*floating.body, frictionless()));
        EXPECT_EQ(m_scene.buoyancy().addBody(*floating.body).error, BodyError::alreadyAdded);
        floating.volume = volumeOf(*floating.shape);
        floating.isFresh = true;
    }

    void push(Floating& floating) {
        floating.body->activate();
        floating.body->applyCentralImpulse(toBullet({uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}) *
                                           floating.body->getMass());
    }

    /// At once, which changes nothing.
    void restore() {
        const ActionState saved = m_scene.buoyancy().save();
        EXPECT_TRUE(m_scene.buoyancy().restore(saved));
        EXPECT_EQ(m_scene.buoyancy().save().bytes, saved.bytes);
    }

    void expectSense() {
        ASSERT_EQ(m_scene.buoyancy().bodyCount(), m_bodies.size());
        for (const Floating& floating : m_bodies) {
            const BodyReport report = m_scene.buoyancy().report(*floating.body);
            EXPECT_FALSE(report.shapeHasChanged);
            EXPECT_TRUE(std::isfinite(report.totalEnergy()) && std::isfinite(report.energy.expected()));
            const bool isStepped =
                report.state == BodyState::floating || report.state == BodyState::submerged;
            if (floating.isFresh || !isStepped) continue;
            EXPECT_LE(report.submergedVolume, floating.volume * (1 + shapeRounding));
            if (report.state == BodyState::submerged) {
                EXPECT_NEAR(report.submergedVolume, floating.volume, floating.volume * shapeRounding);
            }
        }
    }

    FloatScene m_scene;
    std::vector<Floating> m_bodies;
    std::mt19937 m_random;
    int m_actions = 0, m_inTicks = 0;
};

/// Between calls of stepSimulation and in the ticks before and after each substep. The address sanitizer
/// watches.
TEST(Traffic, OfBodiesAndShapesAtRandomTimesDoesNoHarm) {
    for (unsigned seed : {1u, 2u, 3u}) {
        SCOPED_TRACE(seed);
        Traffic traffic(seed, seed == 3 ? 0.5 : 0);
        traffic.run(400);
        EXPECT_GE(traffic.actions(), 700);
        EXPECT_GE(traffic.inTicks(), 300);
    }
}

/// Added before a substep, it is floated in it; added after it, in the next.
TEST(TickCallbacks, MayAddAndRemoveBodies) {
    for (bool isPreTick : {true, false}) {
        FloatScene scene;
        btRigidBody& raft = scene.addBody(box(2, 2, 1), 2000, at({0, 0, -0.1}));
        struct {
            FloatScene& scene;
            btRigidBody& raft;
            int ticks = 0;
        } game{scene, raft};
        const auto onTick = [](btDynamicsWorld* world, btScalar) {
            auto& g = *static_cast<decltype(game)*>(world->getWorldUserInfo());
            ++g.ticks;
            if (g.ticks == 3) static_cast<void>(g.scene.buoyancy().addBody(g.raft));
            if (g.ticks == 40) static_cast<void>(g.scene.buoyancy().removeBody(g.raft));
            if (g.ticks == 42) static_cast<void>(g.scene.buoyancy().addBody(g.raft));
        };
        scene.world().setInternalTickCallback(onTick, &game, isPreTick);
        for (int i = 0; i < 1000; ++i)
            scene.step(4. / 64, 4);
        EXPECT_NEAR(scene.buoyancy().report(raft).wetFraction, 0.5, 1e-4);
        EXPECT_EQ(game.ticks, 4000);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
