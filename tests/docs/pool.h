#pragma once

#include <btBulletDynamicsCommon.h>
#include <bullet_buoyancy/bullet_buoyancy.h>

#include <memory>
#include <vector>

namespace bullet_buoyancy::test {

/// A Bullet world for snippets to float boxes in.
class Pool {
public:
    explicit Pool(const Vec3& gravity = {0, -9.81, 0}) { world.setGravity(toBullet(gravity)); }
    ~Pool() {
        for (const auto& body : m_bodies)
            world.removeRigidBody(body.get());
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Size in m, mass in kg; a mass of 0 makes it static.
    btRigidBody& addBox(const Vec3& size, double mass, const Vec3& position) {
        auto shape = std::make_unique<btBoxShape>(toBullet(size / 2));
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
        auto body = std::make_unique<btRigidBody>(btScalar(mass), nullptr, shape.get(), inertia);
        body->setWorldTransform(toTransform({position, Eigen::Quaterniond::Identity()}));
        world.addRigidBody(body.get());
        m_shapes.push_back(std::move(shape));
        m_bodies.push_back(std::move(body));
        return *m_bodies.back();
    }

    void run(double seconds) {
        for (int step = 0; step < int(60 * seconds); ++step)
            world.stepSimulation(1 / btScalar(60));
    }

private:
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;

public:
    btDiscreteDynamicsWorld world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};

private:
    std::vector<std::unique_ptr<btCollisionShape>> m_shapes;
    std::vector<std::unique_ptr<btRigidBody>> m_bodies;
};

}  // namespace bullet_buoyancy::test
