#pragma once

#include <btBulletDynamicsCommon.h>
#include <bullet_buoyancy/bullet_buoyancy.h>

#include <memory>
#include <vector>

#include "scenes/impulse_buoyancy.h"

namespace bullet_buoyancy::scenes {

/// Who floats the bodies of a scene.
enum class Floater {
    library,   ///< BuoyancyAction
    impulses,  ///< ImpulseBuoyancy, the way of most engines
};

struct SceneDef {
    WaterFrame frame = WaterFrame::zUp();
    double waterDensity = freshWaterDensity;  ///< kg/m^3
    Vec3 flowVelocityWorld = Vec3::Zero();    ///< m/s
    double gravity = standardGravity;         ///< against the frame's up, m/s^2
    Floater floater = Floater::library;
};

/// A Bullet world with flat water in it, and one buoyancy action for all bodies.
class FloatScene {
public:
    explicit FloatScene(const SceneDef& def = {});
    ~FloatScene();
    FloatScene(const FloatScene&) = delete;
    FloatScene& operator=(const FloatScene&) = delete;

    /// A dynamic body of `mass` (kg) with Bullet's own inertia for the shape, kept awake; it floats by itself
    /// only.
    btRigidBody& addBody(std::unique_ptr<btCollisionShape> shape, double mass, const Pose& pose);

    /// The same with given principal moments of inertia (kg m^2).
    btRigidBody& addBody(std::unique_ptr<btCollisionShape> shape, double mass, const Vec3& inertia,
                         const Pose& pose);

    /// A box of given size (m) that floats. `ratio`: its density over the water's.
    btRigidBody& addFloatingBox(const Vec3& size, double ratio, const Pose& pose, const BodyDef& def = {});

    /// Floats a body of the scene, by whoever the scene's floater is.
    BodyStatus floatBody(btRigidBody& body, const BodyDef& def = {});

    /// What the floater did with the body in the last substep.
    BodyReport report(const btRigidBody& body) const;

    btRigidBody& addStatic(std::unique_ptr<btCollisionShape> shape, const Pose& pose);

    /// Linked bodies do not collide with each other.
    void addJoint(std::unique_ptr<btTypedConstraint> joint);

    /// `substeps` of `dt` / `substeps` each in one call of stepSimulation. Throws `Interruption` instead if
    /// the program is asked to end.
    void step(double dt, int substeps = 1);

    /// Steps until `seconds` more have been simulated.
    void run(double seconds, double dt, int substeps = 1);

    btDiscreteDynamicsWorld& world() { return *m_world; }
    const btDiscreteDynamicsWorld& world() const { return *m_world; }
    BuoyancyAction& buoyancy() { return m_buoyancy; }
    btActionInterface& floater();
    const FlatWater& water() const { return m_water; }

    /// Simulated seconds.
    double time() const { return m_time; }

private:
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    std::vector<std::unique_ptr<btCollisionShape>> m_shapes;
    std::vector<std::unique_ptr<btRigidBody>> m_bodies;
    std::vector<std::unique_ptr<btTypedConstraint>> m_joints;
    Floater m_floater;
    FlatWater m_water;
    BuoyancyAction m_buoyancy;
    ImpulseBuoyancy m_impulses;
    std::unique_ptr<btDiscreteDynamicsWorld> m_world;
    double m_time = 0;
};

/// Pose of a body in double precision.
Pose poseOf(const btRigidBody& body);

/// Height of the body's centre of mass above still water, m.
double heightAboveWater(const btRigidBody& body, const WaterField& water);

/// The water's up in the body's axes, unit length.
Vec3 upInBody(const btRigidBody& body, const WaterField& water);

}  // namespace bullet_buoyancy::scenes
