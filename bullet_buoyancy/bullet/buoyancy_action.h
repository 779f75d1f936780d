#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <unordered_map>
#include <vector>

#include "bullet_buoyancy/bullet/action_state.h"
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
/// Bodies may be added, removed and given other hulls between steps, and from Bullet's tick callbacks and
/// other actions, but not by a water's functions in the step.
///
/// Where a task scheduler was given to Bullet (`btSetTaskScheduler`) many bodies are stepped in parallel,
/// with the same results for any number of threads. A step allocates nothing.
class BuoyancyAction : public btActionInterface {
public:
    /// `settings.tolerance` must be finite and not below zero: asserted.
    explicit BuoyancyAction(const WaterField& water, const BuoyancySettings& settings = {});
    explicit BuoyancyAction(const WaterField&&, const BuoyancySettings& = {}) = delete;
    BuoyancyAction(const BuoyancyAction&) = delete;
    BuoyancyAction& operator=(const BuoyancyAction&) = delete;

    /// Floats a dynamic body from the next substep on. Refused bodies are left as they were; the status says
    /// why. A shape is read when the first of the bodies that share it is added.
    BodyStatus addBody(btRigidBody& body, const BodyDef& def = {});

    /// After the body's collision shape was swapped, scaled or changed inside (a compound's children): wets
    /// the shape that it has now, or the given hull, from the next substep on. The body keeps its velocity
    /// and angular momentum, and the ledger takes the change of potential for the work of others (in water
    /// that moves for the water's). Mass and inertia are yours to change. Where it is refused, the status
    /// says why, and the body keeps its hull; its former shape may be deleted all the same.
    BodyStatus updateHull(btRigidBody& body, std::shared_ptr<const Hull> hull = nullptr);

    /// Gives the body back with the angular damping and gyroscopic flags that it came with. False if not
    /// known.
    bool removeBody(btRigidBody& body);

    /// As `removeBody` for each. All of them must still exist.
    void removeAllBodies();

    /// What happened to the body in the last substep. For a body that the action does not know, a report in
    /// the state `notAdded`.
    BodyReport report(const btRigidBody& body) const;

    /// Bodies that were added and not removed, whatever their state.
    std::size_t bodyCount() const { return m_bodies.size(); }

    /// Of the water, at the end of the last substep, s: draw the waves of this moment. It begins at 0 and
    /// goes on with the substeps.
    double time() const { return m_time; }

    /// Lets the water jump to another time (s, finite: asserted).
    void setTime(double time);

    /// For rollback and replays: all of the action that steps change, the settings of its bodies, and what
    /// steps of Bullet change of them (see RigidBodyState). Allocates nothing if `state` has had as many
    /// bodies before.
    ///
    /// Not saved is what is yours: the water (but `time` is, all that its own fields need), the world's
    /// gravity and contacts, joints, bodies that do not float, and the remainder of time that Bullet's world
    /// carries to its next call (none if its steps are whole multiples of the fixed step, or with maxSubSteps
    /// 0).
    void save(ActionState& state) const;
    /// The same in a new state.
    ActionState save() const;

    /// After it, the steps give to the last bit what they gave after `save`, but for what is not saved. The
    /// bodies must have been added with equal hulls, masses, inertia and factors; each is known by its
    /// `BodyDef::id`, or without one by the order of adding. They may be other objects, in another process.
    /// Where it is refused, the status says why and nothing has changed. Allocates nothing.
    RestoreStatus restore(const ActionState& state);

    /// Called by Bullet in each substep; bodies are not touched unless dt (s) is above zero and finite.
    void updateAction(btCollisionWorld* world, btScalar dt) override;

    /// Waterlines and wetted triangles, centres of buoyancy and mass, and the force of the water. Bullet
    /// calls this only when the world's debug drawer draws wireframes, AABBs or normals.
    void debugDraw(btIDebugDraw* drawer) override;

private:
    FloatingBody* find(const btRigidBody& body);
    std::shared_ptr<const Hull> shapesHull(const btRigidBody& body, const Hull* outdated, BodyStatus& status);
    bool isTaken(std::uint64_t id) const;

    const WaterField* m_water;
    BuoyancySettings m_settings;
    double m_time = 0;
    SharedHulls m_hulls;
    std::vector<FloatingBody> m_bodies;
    std::unordered_map<const btRigidBody*, std::size_t> m_index;
};

}  // namespace bullet_buoyancy
