#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <unordered_map>
#include <vector>

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/bullet/body_report.h"
#include "bullet_buoyancy/bullet/body_status.h"
#include "bullet_buoyancy/bullet/buoyancy_settings.h"
#include "bullet_buoyancy/bullet/floating_body.h"
#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/bullet/shared_hulls.h"

namespace bullet_buoyancy {

/// Floats rigid bodies in water: add it to a btDynamicsWorld with `addAction`, and bodies to it with
/// `addBody`.
///
/// Every substep, after Bullet has moved the bodies, it integrates the pressure of the water over each body's
/// hull and sets the velocities with which Bullet goes on. While a body belongs to the action, the library
/// owns its angular momentum and its damping: Bullet's gyroscopic forces and angular damping are off for it,
/// and its linear damping goes on as part of the drag. Bodies weigh what Bullet makes them
/// (`btRigidBody::getGravity`); the pressure of the water comes from the world's gravity along the water's
/// down.
///
/// Between steps `getLinearVelocity` of a wet body contains what is to cancel gravity, g dt upward when it
/// floats at rest: push with impulses or forces, and read `BodyReport::velocity`.
///
/// Not touched: bodies that sleep in still water or where moving water does not reach, and bodies that are
/// not (or no longer) in the world. Moving water wakes what it may reach, and keeps it awake. A body
/// must be removed from the action before it is deleted. The water must outlive the action. Deleting the
/// action gives nothing back, since the bodies may be gone by then: call `removeAllBodies` where it matters.
/// One world an action, and one action a body.
///
/// Where a task scheduler was given to Bullet (`btSetTaskScheduler`) many bodies are stepped in parallel,
/// with the same results for any number of threads. A step allocates nothing.
class BuoyancyAction : public btActionInterface {
public:
    explicit BuoyancyAction(const WaterField& water, const BuoyancySettings& settings = {});
    explicit BuoyancyAction(const WaterField&&, const BuoyancySettings& = {}) = delete;
    BuoyancyAction(const BuoyancyAction&) = delete;
    BuoyancyAction& operator=(const BuoyancyAction&) = delete;

    /// Floats a dynamic body from the next substep on. Refused bodies are left as they were; the status says
    /// why. A shape is read when the first of the bodies that share it is added; a body whose shape was
    /// swapped must be removed before the shape that it was added with is deleted.
    BodyStatus addBody(btRigidBody& body, const BodyDef& def = {});

    /// Gives the body back with the angular damping and gyroscopic flags that it came with. False if not
    /// known.
    bool removeBody(btRigidBody& body);

    void removeAllBodies();

    /// What happened to the body in the last substep. For a body that the action does not know, a report in
    /// the state `notAdded`.
    BodyReport report(const btRigidBody& body) const;

    std::size_t bodyCount() const { return m_bodies.size(); }

    /// Of the water, at the end of the last substep, s: draw the waves of this moment. It begins at 0 and
    /// goes on with the substeps.
    double time() const { return m_time; }

    /// Lets the water jump to another time (s, finite: asserted).
    void setTime(double time);

    /// Called by Bullet in each substep; bodies are not touched unless dt (s) is above zero and finite.
    void updateAction(btCollisionWorld* world, btScalar dt) override;

    /// Waterlines and wetted triangles, centres of buoyancy and mass, and the force of the water. Bullet
    /// calls this only when the world's debug drawer draws wireframes, AABBs or normals.
    void debugDraw(btIDebugDraw* drawer) override;

private:
    const WaterField* m_water;
    BuoyancySettings m_settings;
    double m_time = 0;
    SharedHulls m_hulls;
    std::vector<FloatingBody> m_bodies;
    std::unordered_map<const btRigidBody*, std::size_t> m_index;
};

}  // namespace bullet_buoyancy
