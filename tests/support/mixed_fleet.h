#pragma once

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy::test {

/// Bodies of many kinds at z = 0 in rows, apart from each other but for every tenth, which begins on top of
/// its neighbour: meshes, round solids and compounds, heavy and as light as foam, some in the air, some under
/// water, some asleep where the water lets them.
class MixedFleet {
public:
    /// `world`: z up, to be filled; it must outlive the fleet, and so must the water.
    MixedFleet(btDiscreteDynamicsWorld& world, const WaterField& water, int count)
        : m_world(world), m_buoyancy(water) {
        world.setGravity({0, 0, btScalar(-standardGravity)});
        makeShapes();
        for (int i = 0; i < count; ++i)
            add(i, water.density());
        world.addAction(&m_buoyancy);
    }
    ~MixedFleet() {
        m_world.removeAction(&m_buoyancy);
        for (const auto& body : m_bodies)
            m_world.removeRigidBody(body.get());
    }
    MixedFleet(const MixedFleet&) = delete;
    MixedFleet& operator=(const MixedFleet&) = delete;

    void step() { m_world.stepSimulation(btScalar(1. / 60), 0); }

    const std::vector<std::unique_ptr<btRigidBody>>& bodies() const { return m_bodies; }
    BuoyancyAction& buoyancy() { return m_buoyancy; }

private:
    void makeShapes() {
        m_shapes.push_back(std::make_unique<btBoxShape>(btVector3(0.5, 0.5, 0.25)));
        m_shapes.push_back(std::make_unique<btSphereShape>(btScalar(0.4)));
        m_shapes.push_back(std::make_unique<btCylinderShapeZ>(btVector3(0.25, 0.25, 0.5)));
        auto catamaran = std::make_unique<btCompoundShape>();
        for (const btScalar side : {btScalar(-1), btScalar(1)})
            catamaran->addChildShape(btTransform(btQuaternion::getIdentity(), {0, side / 2, 0}),
                                     m_shapes.front().get());
        m_shapes.push_back(std::move(catamaran));
    }

    void add(int i, double density) {
        btCollisionShape& shape = *m_shapes[std::size_t(i) % m_shapes.size()];
        const double displacement = hullFromShape(shape).hull->moments.volume;
        const double ratios[] = {0.5, 0.02, 0.9, 0.3, 1.2};
        const double mass = ratios[i % 5] * density * displacement;
        btVector3 inertia;
        shape.calculateLocalInertia(btScalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, &shape, inertia);
        const bool onTop = i % 10 == 9;
        const Vec3 position(3.0 * (i % 16) - (onTop ? 2.9 : 0), 3.0 * (i / 16), onTop ? 1.2 : std::sin(i));
        info.m_startWorldTransform = toTransform(
            {position, Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::sin(3 * i), Vec3::UnitX()))});
        m_bodies.push_back(std::make_unique<btRigidBody>(info));
        m_world.addRigidBody(m_bodies.back().get());
        m_buoyancy.addBody(*m_bodies.back());
        if (i % 7 == 6) m_bodies.back()->forceActivationState(ISLAND_SLEEPING);
    }

    btDiscreteDynamicsWorld& m_world;
    BuoyancyAction m_buoyancy;
    std::vector<std::unique_ptr<btCollisionShape>> m_shapes;
    std::vector<std::unique_ptr<btRigidBody>> m_bodies;
};

}  // namespace bullet_buoyancy::test
