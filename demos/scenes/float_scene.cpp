#include "scenes/float_scene.h"

#include <cassert>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/interruption.h"
#include "scenes/scene_watch.h"

namespace bullet_buoyancy::scenes {

FloatScene::FloatScene(const SceneDef& def)
    : m_floater(def.floater),
      m_water(def.frame, {def.waterDensity, def.flowVelocityWorld}),
      m_buoyancy(m_water),
      m_impulses(m_water),
      m_world(std::make_unique<btDiscreteDynamicsWorld>(&m_dispatcher, &m_broadphase, &m_solver,
                                                        &m_configuration)) {
    m_world->setGravity(toBullet(-def.gravity * def.frame.upWorld()));
    m_world->addAction(&m_buoyancy);
    m_world->addAction(&m_impulses);
}

FloatScene::~FloatScene() {
    m_world->removeAction(&m_impulses);
    m_world->removeAction(&m_buoyancy);
    for (const auto& joint : m_joints)
        m_world->removeConstraint(joint.get());
    for (const auto& body : m_bodies)
        m_world->removeRigidBody(body.get());
}

btRigidBody& FloatScene::addBody(std::unique_ptr<btCollisionShape> shape, double mass, const Pose& pose) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
    return addBody(std::move(shape), mass, toEigen(inertia), pose);
}

btRigidBody& FloatScene::addBody(std::unique_ptr<btCollisionShape> shape, double mass, const Vec3& inertia,
                                 const Pose& pose) {
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, shape.get(), toBullet(inertia));
    info.m_startWorldTransform = toTransform(pose);
    auto body = std::make_unique<btRigidBody>(info);
    if (mass > 0) body->setActivationState(DISABLE_DEACTIVATION);
    m_world->addRigidBody(body.get());
    m_shapes.push_back(std::move(shape));
    m_bodies.push_back(std::move(body));
    return *m_bodies.back();
}

btRigidBody& FloatScene::addFloatingBox(const Vec3& size, double ratio, const Pose& pose,
                                        const BodyDef& def) {
    auto shape = std::make_unique<btBoxShape>(toBullet(size / 2));
    btRigidBody& body = addBody(std::move(shape), ratio * m_water.density() * size.prod(), pose);
    const BodyStatus status = floatBody(body, def);
    assert(status.ok());
    static_cast<void>(status);
    return body;
}

BodyStatus FloatScene::floatBody(btRigidBody& body, const BodyDef& def) {
    return m_floater == Floater::library ? m_buoyancy.addBody(body, def) : m_impulses.addBody(body, def);
}

BodyReport FloatScene::report(const btRigidBody& body) const {
    return m_floater == Floater::library ? m_buoyancy.report(body) : m_impulses.report(body);
}

btActionInterface& FloatScene::floater() {
    if (m_floater == Floater::library) return m_buoyancy;
    return m_impulses;
}

btRigidBody& FloatScene::addStatic(std::unique_ptr<btCollisionShape> shape, const Pose& pose) {
    return addBody(std::move(shape), 0, pose);
}

void FloatScene::addJoint(std::unique_ptr<btTypedConstraint> joint) {
    m_world->addConstraint(joint.get(), true);
    m_joints.push_back(std::move(joint));
}

void FloatScene::step(double dt, int substeps) {
    throwIfInterrupted();
    if (m_time == 0) SceneWatch::show(*this);
    const auto fixedStep = btScalar(dt / substeps);
    if (substeps == 1)
        m_world->stepSimulation(fixedStep, 0);
    else
        m_world->stepSimulation(fixedStep * btScalar(substeps), substeps, fixedStep);
    m_time += dt;
    SceneWatch::show(*this);
}

void FloatScene::run(double seconds, double dt, int substeps) {
    const long steps = std::lround(seconds / dt);
    for (long i = 0; i < steps; ++i)
        step(dt, substeps);
}

Pose poseOf(const btRigidBody& body) {
    return toPose(body.getWorldTransform());
}

double heightAboveWater(const btRigidBody& body, const WaterField& water) {
    return water.frame().pointFromWorld(toEigen(body.getWorldTransform().getOrigin())).z();
}

Vec3 upInBody(const btRigidBody& body, const WaterField& water) {
    return poseOf(body).orientation.conjugate() * water.frame().upWorld();
}

}  // namespace bullet_buoyancy::scenes
