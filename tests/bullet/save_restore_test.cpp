#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/rigid_body_state.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/float_scene.h"
#include "scenes/study_seas.h"
#include "support/bullet_cases.h"
#include "support/mixed_fleet.h"

namespace bullet_buoyancy::test {
namespace {

using Bits = std::vector<double>;

void append(Bits& bits, const btVector3& v) {
    bits.insert(bits.end(), {double(v.x()), double(v.y()), double(v.z())});
}

/// All that can be seen of a body and of what the action says of it.
void append(Bits& bits, const btRigidBody& body, const BodyReport& report) {
    for (const btTransform& transform : {body.getWorldTransform(), body.getInterpolationWorldTransform()}) {
        for (int row = 0; row < 3; ++row)
            append(bits, transform.getBasis()[row]);
        append(bits, transform.getOrigin());
    }
    for (const btVector3& v : {body.getLinearVelocity(), body.getAngularVelocity(), report.forceWorld,
                               report.torqueAboutCom, report.velocity, report.angularMomentum})
        append(bits, v);
    bits.insert(bits.end(), {double(body.getActivationState()), double(body.getDeactivationTime()),
                             double(body.getLinearDamping()), double(report.state), report.totalEnergy(),
                             report.energy.expected(), report.energy.byOthers, report.forceErrorBound,
                             double(report.evaluations), double(report.spinIsLimited)});
}

bool isSame(const Bits& a, const Bits& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// A world without contacts, in which bodies of all sorts, two of them joined, go through all that the action
/// does: made and pushed alike each time.
class Voyage {
public:
    explicit Voyage(const WaterField& water, const BodyDef& def = {}) : m_buoyancy(water, rough()) {
        m_world.setGravity({0, 0, btScalar(-standardGravity)});
        makeShapes();
        for (int i = 0; i < 14; ++i)
            add(i, def);
        m_joint = std::make_unique<btPoint2PointConstraint>(*m_bodies[12], *m_bodies[13], btVector3(1, 0, 0),
                                                            btVector3(-1, 0, 0));
        m_world.addConstraint(m_joint.get(), true);
        m_world.addAction(&m_buoyancy);
    }
    ~Voyage() {
        m_world.removeAction(&m_buoyancy);
        m_world.removeConstraint(m_joint.get());
        for (const auto& body : m_bodies)
            m_world.removeRigidBody(body.get());
    }
    Voyage(const Voyage&) = delete;
    Voyage& operator=(const Voyage&) = delete;

    /// Call number `index` of stepSimulation.
    using Stepping = std::function<void(btDiscreteDynamicsWorld& world, int index)>;

    /// What is seen of the steps from `first` on.
    Bits run(int first, int steps, const Stepping& stepping) {
        Bits bits;
        for (int i = first; i < first + steps; ++i) {
            push(i);
            stepping(m_world, i);
            for (const auto& body : m_bodies) {
                const BodyReport report = m_buoyancy.report(*body);
                append(bits, *body, report);
                ++m_met[std::size_t(report.state)];
            }
        }
        return bits;
    }

    /// Its bodies are met in another motion, and by the action for the first time.
    void upset() {
        m_buoyancy.removeAllBodies();
        for (const auto& body : m_bodies) {
            body->setLinearVelocity({3, 2, 1});
            EXPECT_TRUE(m_buoyancy.addBody(*body));
        }
    }

    /// How often a body was seen in a state.
    int met(BodyState state) const { return m_met[std::size_t(state)]; }

    BuoyancyAction& buoyancy() { return m_buoyancy; }
    btRigidBody& body(std::size_t i) { return *m_bodies[i]; }
    btDiscreteDynamicsWorld& world() { return m_world; }

private:
    static BuoyancySettings rough() {
        BuoyancySettings settings;
        settings.tolerance = 3e-2;
        return settings;
    }

    void makeShapes() {
        m_shapes.push_back(std::make_unique<btBoxShape>(btVector3(0.5, 0.5, 0.25)));
        m_shapes.push_back(std::make_unique<btBoxShape>(btVector3(btScalar(0.15), btScalar(0.2), 0.25)));
        m_shapes.push_back(std::make_unique<btSphereShape>(btScalar(0.4)));
        m_shapes.push_back(std::make_unique<btCapsuleShapeZ>(btScalar(0.3), 1));
        auto catamaran = std::make_unique<btCompoundShape>();
        for (const btScalar side : {btScalar(-1), btScalar(1)})
            catamaran->addChildShape(btTransform(btQuaternion::getIdentity(), {0, side, 0}),
                                     m_shapes[0].get());
        m_shapes.push_back(std::move(catamaran));
    }

    void add(int i, const BodyDef& def) {
        btCollisionShape& shape = *m_shapes[std::size_t(i) % m_shapes.size()];
        const double ratios[] = {0.5, 0.02, 0.9, 1.2, 0.3, 0.001, 0.5};
        const double mass = ratios[i % 7] * freshWaterDensity * hullFromShape(shape).hull->moments.volume;
        btVector3 inertia;
        shape.calculateLocalInertia(btScalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, &shape, inertia);
        const double height = i == 6 ? 0 : i == 8 ? 500 : 2 * std::sin(i);
        info.m_startWorldTransform =
            toTransform({{i == 13 ? 482 : 40.0 * i, 0, height},
                         Eigen::Quaterniond(Eigen::AngleAxisd(i == 6 ? 0 : std::sin(3 * i), Vec3::UnitX()))});
        m_bodies.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& body = *m_bodies.back();
        if (i % 3 == 1) body.setActivationState(DISABLE_DEACTIVATION);
        if (i == 4) body.setDamping(btScalar(0.1), btScalar(0.3));
        if (i == 5) body.setAngularFactor(btVector3(0, 1, 0));
        if (i == 7) body.setLinearFactor({1, 0, 1});
        if (i == 8) body.setAngularVelocity({1, 5, btScalar(0.3)});  // tumbles in the air
        if (i == 9) body.setAngularVelocity({0, 0, 90});             // faster than Bullet can follow
        m_world.addRigidBody(&body);
        if (i == 10) body.setGravity({0, 0, -3});
        EXPECT_TRUE(m_buoyancy.addBody(body, def));
    }

    /// Blows and forces, which also wake what sleeps.
    void push(int index) {
        if (index % 97 == 10) {
            btRigidBody& body = *m_bodies[std::size_t(index) % m_bodies.size()];
            body.activate();
            body.applyImpulse(btVector3(1, btScalar(0.5), 2) / body.getInvMass(), {btScalar(0.1), 0, 0});
        }
        if (index % 41 < 5) m_bodies[2]->applyCentralForce({50, 0, 20});
        if (index == 700) m_bodies[6]->setLinearVelocity({0, 0, -1});
    }

    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    BuoyancyAction m_buoyancy;
    std::vector<std::unique_ptr<btCollisionShape>> m_shapes;
    std::vector<std::unique_ptr<btRigidBody>> m_bodies;
    std::unique_ptr<btTypedConstraint> m_joint;
    std::array<int, 16> m_met{};
};

void single(btDiscreteDynamicsWorld& world, int) {
    world.stepSimulation(btScalar(1. / 60), 0);
}

/// Of a binary fraction, so that Bullet's clock has no remainder.
void manySubsteps(btDiscreteDynamicsWorld& world, int) {
    world.stepSimulation(btScalar(3. / 64), 4, btScalar(1. / 64));
}

void uneven(btDiscreteDynamicsWorld& world, int index) {
    const btScalar steps[] = {btScalar(1. / 60), btScalar(1. / 45), btScalar(1. / 144)};
    world.stepSimulation(steps[index % 3], 0);
}

constexpr int before = 400, after = 1000;

/// In the world that it was saved in, and, as when a replay is taken up by another process, in one made anew.
void expectTheSameSteps(const WaterField& water, const Voyage::Stepping& stepping) {
    Voyage voyage(water);
    voyage.run(0, before, stepping);
    const ActionState saved = voyage.buoyancy().save();
    const Bits first = voyage.run(before, after, stepping);
    const ActionState end = voyage.buoyancy().save();
    EXPECT_GT(voyage.met(BodyState::floating), 0);
    EXPECT_GT(voyage.met(BodyState::submerged), 0);
    EXPECT_GT(voyage.met(BodyState::dry), 0);
    EXPECT_EQ(voyage.met(BodyState::asleep) > 0, water.bounds().still);

    Voyage again(water);
    for (Voyage* other : {&voyage, &again}) {
        ASSERT_TRUE(other->buoyancy().restore(saved));
        EXPECT_EQ(other->buoyancy().save().bytes, saved.bytes);
        EXPECT_TRUE(isSame(other->run(before, after, stepping), first));
        EXPECT_EQ(other->buoyancy().save().bytes, end.bytes);
    }
}

TEST(TheThousandStepsAfterRestore, AreTheSameInStillWater) {
    expectTheSameSteps(FlatWater(WaterFrame::zUp()), single);
}

TEST(TheThousandStepsAfterRestore, AreTheSameByManySubsteps) {
    expectTheSameSteps(FlatWater(WaterFrame::zUp()), manySubsteps);
}

TEST(TheThousandStepsAfterRestore, AreTheSameByUnevenSteps) {
    expectTheSameSteps(FlatWater(WaterFrame::zUp()), uneven);
}

TEST(TheThousandStepsAfterRestore, AreTheSameInACurrent) {
    FlatWaterDef river;
    river.flowVelocityWorld = {1, 0.5, 0};
    expectTheSameSteps(FlatWater(WaterFrame::zUp(), river), single);
}

scenes::StudySeaDef waves() {
    scenes::StudySeaDef def;
    def.significantHeight = 0.5;
    def.components = 4;
    return def;
}

TEST(TheThousandStepsAfterRestore, AreTheSameInLinearWaves) {
    expectTheSameSteps(*scenes::airySea("sea", waves()).water, single);
}

TEST(TheThousandStepsAfterRestore, AreTheSameInTrochoidsByUnevenSteps) {
    expectTheSameSteps(*scenes::gerstnerSea("sea", waves()).water, uneven);
}

/// Every moment of a voyage is as good as any: while bodies sleep, fly, are woken, spin too fast.
TEST(SaveAndRestore, AnyMomentMayBeSaved) {
    const FlatWater water(WaterFrame::zUp());
    Voyage voyage(water), again(water);
    again.upset();
    constexpr int ahead = 5;
    for (int start = 0; start < 600; start += ahead) {
        ActionState saved;
        voyage.buoyancy().save(saved);
        const Bits first = voyage.run(start, ahead, single);
        ASSERT_TRUE(again.buoyancy().restore(saved));
        ASSERT_TRUE(isSame(again.run(start, ahead, single), first)) << start;
    }
}

TEST(SaveAndRestore, SettingsOfBodiesAreRestored) {
    const FlatWater water(WaterFrame::zUp());
    BodyDef def;
    def.linearDrag = 0.5;
    def.angularDamping = 7;
    def.scaleByWetFraction = false;
    def.scheme = StepScheme::published;
    Voyage voyage(water, def);
    voyage.run(0, 30, single);
    const ActionState saved = voyage.buoyancy().save();
    const Bits first = voyage.run(30, 60, single);
    Voyage others(water);
    ASSERT_TRUE(others.buoyancy().restore(saved));
    EXPECT_TRUE(isSame(others.run(30, 60, single), first));
}

TEST(SaveAndRestore, ForcesThatWaitForTheNextStepAreRestored) {
    const FlatWater water(WaterFrame::zUp());
    Voyage voyage(water), again(water);
    voyage.body(0).applyForce({1000, 0, 500}, {0, btScalar(0.5), 0});
    voyage.body(7).applyForce({300, 200, 100}, {0, btScalar(0.5), 0});
    const ActionState saved = voyage.buoyancy().save();
    ASSERT_TRUE(again.buoyancy().restore(saved));
    EXPECT_EQ(again.body(0).getTotalForce(), voyage.body(0).getTotalForce());
    EXPECT_EQ(again.body(7).getTotalTorque(), voyage.body(7).getTotalTorque());
    EXPECT_TRUE(isSame(again.run(0, 60, single), voyage.run(0, 60, single)));
}

TEST(SaveAndRestore, ABodyIsGivenBackAsTheSavedOneCame) {
    const FlatWater water(WaterFrame::zUp());
    Voyage voyage(water), again(water);
    voyage.body(0).setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
    voyage.body(0).setDamping(btScalar(0.2), btScalar(0.4));
    voyage.run(0, 10, single);
    ASSERT_TRUE(again.buoyancy().restore(voyage.buoyancy().save()));
    ASSERT_TRUE(again.buoyancy().removeBody(again.body(0)));
    EXPECT_EQ(again.body(0).getFlags(), BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
    EXPECT_EQ(again.body(0).getLinearDamping(), btScalar(0.2));
    EXPECT_EQ(again.body(0).getAngularDamping(), btScalar(0.4));
}

/// Contacts are not saved: worlds made anew go on alike all the same.
TEST(SaveAndRestore, NewWorldsWithContactsGoOnAlike) {
    const FlatWater water(WaterFrame::zUp());
    const auto restored = [&](const ActionState& saved) {
        btDefaultCollisionConfiguration configuration;
        btCollisionDispatcher dispatcher(&configuration);
        btDbvtBroadphase broadphase;
        btSequentialImpulseConstraintSolver solver;
        btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
        MixedFleet fleet(world, water, 40);
        if (saved.bytes.empty()) {
            for (int i = 0; i < 60; ++i)
                fleet.step();
        } else {
            EXPECT_TRUE(fleet.buoyancy().restore(saved));
            for (int i = 0; i < 300; ++i)
                fleet.step();
        }
        return fleet.buoyancy().save();
    };
    const ActionState saved = restored({});
    EXPECT_EQ(restored(saved).bytes, restored(saved).bytes);
}

TEST(SaveAndRestore, HullsStayTheUsers) {
    scenes::FloatScene scene;
    btRigidBody& body = scene.addBody(std::make_unique<btBoxShape>(btVector3(1, 1, 1)), 1000, at({0, 0, 0}));
    BodyDef def;
    def.hull = hullFromShape(*body.getCollisionShape()).hull;
    ASSERT_TRUE(scene.buoyancy().addBody(body, def));
    const long users = def.hull.use_count();
    const ActionState saved = scene.buoyancy().save();
    scene.run(1, dt);
    ASSERT_TRUE(scene.buoyancy().restore(saved));
    EXPECT_EQ(def.hull.use_count(), users);
}

TEST(RigidBodyState, IsTheWholeOfABodyInTheAir) {
    scenes::FloatScene scene;
    btRigidBody& body =
        scene.addBody(std::make_unique<btBoxShape>(btVector3(1, 2, 3)), 1000, at({0, 0, 500}));
    body.setAngularVelocity({1, 2, 3});
    scene.run(1, dt);
    body.applyTorque({0, 1000, 0});
    const RigidBodyState saved(body);
    const auto afterwards = [&] {
        scene.run(2, dt);
        Bits bits;
        append(bits, body, {});
        return bits;
    };
    const Bits first = afterwards();
    saved.putInto(body);
    EXPECT_TRUE(isSame(afterwards(), first));
}

/// Three crates, floating, as in the other scene or with one thing that differs.
struct Crates {
    explicit Crates(int count = 3, const Vec3& firstSize = {1, 1, 1}, double ratio = 0.5) {
        for (int i = 0; i < count; ++i)
            bodies.push_back(&scene.addFloatingBox(i == 0 ? firstSize : Vec3(1, 1, 1), i == 1 ? ratio : 0.5,
                                                   at({4.0 * i, 0, 0.1 * i})));
        scene.run(1, dt);
    }

    void expectRefused(const ActionState& state, RestoreError why, std::size_t body = 0) {
        const ActionState present = scene.buoyancy().save();
        const RestoreStatus status = scene.buoyancy().restore(state);
        EXPECT_FALSE(status);
        EXPECT_EQ(status.error, why) << status.describe();
        EXPECT_EQ(status.body, body) << status.describe();
        EXPECT_EQ(scene.buoyancy().save().bytes, present.bytes);
    }

    scenes::FloatScene scene;
    std::vector<btRigidBody*> bodies;
};

TEST(Restore, RefusesBytesThatAreNoState) {
    Crates crates;
    crates.expectRefused({}, RestoreError::notAState);
    crates.expectRefused({std::vector<std::byte>(7)}, RestoreError::notAState);
    crates.expectRefused({std::vector<std::byte>(100000)}, RestoreError::notAState);
}

TEST(Restore, RefusesWhatWasCutShort) {
    Crates crates;
    const ActionState whole = crates.scene.buoyancy().save();
    for (std::size_t size = 0; size < whole.bytes.size(); size += size < 200 ? 1 : 101) {
        ActionState cut = whole;
        cut.bytes.resize(size);
        crates.expectRefused(cut, size < 8 ? RestoreError::notAState : RestoreError::damaged);
    }
    ActionState longer = whole;
    longer.bytes.push_back(std::byte(0));
    crates.expectRefused(longer, RestoreError::damaged);
}

TEST(Restore, RefusesWhatWasChangedAnywhere) {
    Crates crates;
    const ActionState whole = crates.scene.buoyancy().save();
    for (std::size_t i = 0; i < whole.bytes.size(); ++i) {
        ActionState changed = whole;
        changed.bytes[i] ^= std::byte(1 << (i % 8));
        ASSERT_FALSE(crates.scene.buoyancy().restore(changed)) << i;
    }
    EXPECT_EQ(crates.scene.buoyancy().save().bytes, whole.bytes);
}

TEST(Restore, NamesAnotherVersionAndAnotherPrecision) {
    Crates crates;
    ActionState state = crates.scene.buoyancy().save();
    state.bytes[16] = std::byte(12 - sizeof(btScalar));
    crates.expectRefused(state, RestoreError::otherPrecision);
    state.bytes[8] ^= std::byte(128);
    crates.expectRefused(state, RestoreError::otherVersion);
}

TEST(Restore, NamesTheBodyThatDiffers) {
    const ActionState saved = Crates().scene.buoyancy().save();
    Crates(2).expectRefused(saved, RestoreError::otherBodies, 2);
    Crates(4).expectRefused(saved, RestoreError::otherBodies, 3);
    Crates(3, {1, 1, 1.1}).expectRefused(saved, RestoreError::otherHull, 0);
    Crates(3, {1, 1, 1}, 0.6).expectRefused(saved, RestoreError::otherInertia, 1);
    Crates locked;
    locked.bodies[2]->setAngularFactor(btVector3(0, 0, 1));
    locked.expectRefused(saved, RestoreError::otherInertia, 2);
    EXPECT_TRUE(Crates().scene.buoyancy().restore(saved));
}

TEST(Restore, NamesOtherSettings) {
    const ActionState saved = BuoyancyAction(Crates().scene.water()).save();
    const FlatWater water(WaterFrame::zUp());
    BuoyancySettings settings;
    settings.tolerance = 0.5 * BuoyancySettings().tolerance;
    EXPECT_EQ(BuoyancyAction(water, settings).restore(saved).error, RestoreError::otherSettings);
    settings.tolerance = BuoyancySettings().tolerance;
    settings.pressure = PressureModel::waveDynamic;
    EXPECT_EQ(BuoyancyAction(water, settings).restore(saved).error, RestoreError::otherSettings);
    EXPECT_TRUE(BuoyancyAction(water).restore(saved));
}

TEST(BodyId, IsTakenOnlyOnce) {
    scenes::FloatScene scene;
    BodyDef def;
    def.id = 7;
    scene.addFloatingBox({1, 1, 1}, 0.5, at({0, 0, 0}), def);
    btRigidBody& second = scene.addBody(std::make_unique<btSphereShape>(btScalar(1)), 10, at({5, 0, 0}));
    EXPECT_EQ(scene.buoyancy().addBody(second, def).error, BodyError::idTaken);
    def.id = 8;
    EXPECT_TRUE(scene.buoyancy().addBody(second, def));
}

/// A body that is taken out and added anew is at another place in the order.
TEST(BodyId, FindsABodyWhateverTheOrder) {
    scenes::FloatScene scene;
    std::vector<btRigidBody*> crates;
    for (int i = 0; i < 4; ++i) {
        BodyDef def;
        def.id = i % 2 == 0 ? std::uint64_t(100 + i) : 0;
        crates.push_back(&scene.addFloatingBox({1, 1, 1}, 0.5, at({3.0 * i, 0, 0.1 * i}), def));
    }
    scene.run(0.5, dt);
    const ActionState saved = scene.buoyancy().save();
    std::vector<btTransform> where;
    for (const btRigidBody* crate : crates)
        where.push_back(crate->getWorldTransform());
    scene.run(1, dt);

    scene.buoyancy().removeBody(*crates[0]);
    const RestoreStatus status = scene.buoyancy().restore(saved);
    EXPECT_EQ(status.error, RestoreError::otherBodies);
    EXPECT_EQ(status.id, 100u);
    EXPECT_NE(status.describe().find("id 100"), std::string::npos);

    BodyDef def;
    def.id = 100;
    ASSERT_TRUE(scene.buoyancy().addBody(*crates[0], def));
    ASSERT_TRUE(scene.buoyancy().restore(saved));
    for (std::size_t i = 0; i < crates.size(); ++i)
        EXPECT_EQ(crates[i]->getWorldTransform(), where[i]) << i;
}

TEST(RestoreStatus, SaysWhatDiffers) {
    for (RestoreError error :
         {RestoreError::notAState, RestoreError::otherVersion, RestoreError::otherPrecision,
          RestoreError::damaged, RestoreError::otherSettings, RestoreError::otherBodies,
          RestoreError::otherHull, RestoreError::otherInertia}) {
        RestoreStatus status;
        const std::string fine = status.describe();
        status.error = error;
        EXPECT_FALSE(status.describe().empty());
        EXPECT_NE(status.describe(), fine);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
