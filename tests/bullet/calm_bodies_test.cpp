#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <cstring>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/handover_kernels.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "support/instruction_sets.h"
#include "support/random_rows.h"

namespace bullet_buoyancy::test {
namespace {

constexpr int bodies = 21;  // two blocks and a rest
constexpr int steps = 150;

/// A world for some of the bodies, each at its place, far from the others.
class World {
public:
    explicit World(const std::vector<int>& which)
        : m_dispatcher(&m_configuration),
          m_world(&m_dispatcher, &m_broadphase, &m_solver, &m_configuration),
          m_buoyancy(m_water) {
        m_world.setGravity({0, 0, btScalar(-standardGravity)});
        m_hull.addPoint({btScalar(0.5), 0, 0});
        m_hull.addPoint({btScalar(-0.5), btScalar(0.4), 0});
        m_hull.addPoint({btScalar(-0.5), btScalar(-0.4), 0});
        m_hull.addPoint({0, 0, btScalar(0.6)});
        for (int i : which)
            add(i);
        m_world.addAction(&m_buoyancy);
    }
    ~World() {
        for (const auto& body : m_bodies)
            m_world.removeRigidBody(body.get());
    }

    /// Some are pushed, some are held for a while, one is woken, one is made heavier.
    void step(int time) {
        for (std::size_t place = 0; place < m_bodies.size(); ++place) {
            btRigidBody& body = *m_bodies[place];
            const int i = m_numbers[place];
            if (i % 4 == 1 && time % 20 == i) body.applyCentralImpulse({0, btScalar(20), btScalar(-30)});
            if (i % 7 == 2 && time > 40 && time < 60) body.applyCentralForce({btScalar(300), 0, 0});
            if (i % 5 == 3 && time == 50) body.setAngularVelocity({btScalar(2), 0, btScalar(0.1)});
            if (i == 6 && time == 70) body.setDamping(btScalar(0.1), btScalar(0.1));
            if (i == 8 && time == 80) body.setMassProps(300, body.getLocalInertia());
        }
        m_world.stepSimulation(btScalar(1. / 60), 0);
    }

    std::vector<double> state(int i) const {
        std::vector<double> numbers;
        const auto add = [&](const btVector3& v) {
            numbers.insert(numbers.end(), {double(v.x()), double(v.y()), double(v.z())});
        };
        for (std::size_t place = 0; place < m_bodies.size(); ++place) {
            if (m_numbers[place] != i) continue;
            const btRigidBody& body = *m_bodies[place];
            for (int row = 0; row < 3; ++row)
                add(body.getWorldTransform().getBasis()[row]);
            add(body.getWorldTransform().getOrigin());
            add(body.getLinearVelocity());
            add(body.getAngularVelocity());
            const BodyReport report = m_buoyancy.report(body);
            add(report.forceWorld);
            add(report.torqueAboutCom);
            add(report.angularMomentum);
            numbers.insert(numbers.end(),
                           {report.totalEnergy(), report.energy.toDrag, report.energy.toDamping,
                            double(report.state), double(body.getActivationState())});
        }
        return numbers;
    }

private:
    void add(int i) {
        btCollisionShape* const shapes[] = {&m_box, &m_ball, &m_hull, &m_cylinder};
        btCollisionShape& shape = *shapes[i % 3 == 2 ? i % 4 : 0];
        btVector3 inertia;
        const btScalar mass = btScalar(100 + 20 * (i % 5));
        shape.calculateLocalInertia(mass, inertia);
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
        info.m_startWorldTransform = btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(0.02 * i)),
                                                 {btScalar(20 * i), 0, btScalar(0.02 * i - 0.2)});
        m_bodies.push_back(std::make_unique<btRigidBody>(info));
        m_numbers.push_back(i);
        m_world.addRigidBody(m_bodies.back().get());
        m_buoyancy.addBody(*m_bodies.back());
    }

    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher;
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world;
    FlatWater m_water{WaterFrame::zUp()};
    BuoyancyAction m_buoyancy;
    btBoxShape m_box{btVector3(btScalar(0.5), btScalar(0.4), btScalar(0.3))};
    btSphereShape m_ball{btScalar(0.4)};
    btConvexHullShape m_hull;
    btCylinderShapeZ m_cylinder{btVector3(btScalar(0.3), btScalar(0.3), btScalar(0.4))};
    std::vector<std::unique_ptr<btRigidBody>> m_bodies;
    std::vector<int> m_numbers;
};

/// They share blocks in one world, and have one each in the others.
TEST(CalmBodies, AreSteppedTogetherAsEachIsAlone) {
    std::vector<int> all;
    for (int i = 0; i < bodies; ++i)
        all.push_back(i);
    World together(all);
    std::vector<std::unique_ptr<World>> alone;
    for (int i : all)
        alone.push_back(std::make_unique<World>(std::vector<int>{i}));
    for (int time = 0; time < steps; ++time) {
        together.step(time);
        for (int i : all) {
            World& world = *alone[std::size_t(i)];
            world.step(time);
            ASSERT_EQ(together.state(i), world.state(i)) << "body " << i << " at " << time;
        }
    }
}

struct HandedOver {
    ReturnRows returns{};
    GiftRows gifts{};
};

HandedOver handOver(InstructionSet set, const PoseRows& poses, const ReturnRows& returns,
                    const VectorRows& departure, const PoseRows& targets) {
    constexpr double dt = 1.0 / 60, rounding = std::numeric_limits<btScalar>::epsilon();
    HandedOver handed;
    handed.returns = returns;
    handoverKernels(set).take(poses, dt, rounding, handed.returns);
    handoverKernels(set).give(poses, handed.returns, departure, targets, dt, rounding, handed.gifts);
    return handed;
}

TEST(CalmBodies, AreHandedOverAlikeByAllSets) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        PoseRows poses, targets;
        fill(poses, random, 10);
        ReturnRows returns;
        VectorRows departure;
        for (VectorRows* rows :
             {&returns.velocity, &returns.given, &returns.force, &returns.gravity, &departure})
            fill(*rows, random, 1);
        fill(returns.inverseMass, random, 0, 1);
        fill(returns.longestStep, random, 0.01, 1);
        for (int lane = 0; lane < blockSize; ++lane) {
            Pose pose = poseOf(poses, lane);
            const Mat3 axes = pose.worldFromBody();
            for (int row = 0; row < 3; ++row)
                put(axes.row(row), returns.axes[row], lane);
            put(pose.position, returns.position, lane);
            pose.position += random.inCube(0.1);
            pose.orientation =
                pose.orientation * Eigen::Quaterniond(Eigen::AngleAxisd(0.01, random.direction()));
            put(pose, targets, lane);
        }
        const HandedOver portable = handOver(InstructionSet::portable, poses, returns, departure, targets);
        for (InstructionSet set : setsOfThisMachine()) {
            const HandedOver handed = handOver(set, poses, returns, departure, targets);
            EXPECT_EQ(std::memcmp(&handed.gifts, &portable.gifts, sizeof handed.gifts), 0) << nameOf(set);
            EXPECT_EQ(
                std::memcmp(&handed.returns.isUndisturbed, &portable.returns.isUndisturbed, sizeof(BodyRow)),
                0);
        }
    }
}

}  // namespace
}  // namespace bullet_buoyancy::test
