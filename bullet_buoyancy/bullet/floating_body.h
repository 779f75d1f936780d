#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/bullet/body_report.h"
#include "bullet_buoyancy/bullet/body_status.h"
#include "bullet_buoyancy/bullet/borrowed_settings.h"
#include "bullet_buoyancy/bullet/calm_rows.h"
#include "bullet_buoyancy/bullet/handover.h"
#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/bullet/water_load.h"

namespace bullet_buoyancy {

/// One rigid body in the care of the action: what was borrowed from Bullet, and its motion.
class FloatingBody {
public:
    /// Checks body and settings; changes nothing.
    static BodyStatus check(const btRigidBody& body, const BodyDef& def);

    /// A hull given by the user, or if null whether the body has a shape to read one from.
    static BodyStatus checkHull(const btRigidBody& body, const Hull* hull);

    /// Takes the body's damping and rotation over from Bullet, and wakes it. `def` must have a hull and have
    /// passed `check`.
    FloatingBody(btRigidBody& body, const BodyDef& def);

    /// Gives the body's damping and gyroscopic flags back as they came, and wakes it.
    void giveBack();

    /// One substep of `dt` > 0 (s), after Bullet has moved the body.
    void step(const WaterNow& water, double dt);

    /// Whether it rocks or lies in calm water, as far as can be told before its step: one of those that
    /// kernels may step, if `CalmBlock::isFor` the water. It is not asleep.
    bool isAtEase(const WaterNow& water, double dt) const;

    /// What the kernels take.
    void put(CalmRows& rows, int lane) const;

    /// One substep, as the kernels found it.
    void stepCalmly(const CalmRows& rows, int lane, const WaterNow& water, double dt);

    /// The body is not touched, for this reason.
    void skip(BodyState reason);

    /// The next step does not end in the water that the body was shown when it began.
    void forgetWaterAhead() { m_motion.forgetLoadAhead(); }

    /// The body goes on as it moves, with another hull (not null), and is woken. The shape that it has now is
    /// the one to be told from others.
    void changeHull(std::shared_ptr<const Hull> hull);

    btRigidBody& body() { return *m_body; }
    const btRigidBody& body() const { return *m_body; }
    const Hull& hull() const { return *m_def.hull; }
    BodyState state() const { return m_state; }
    std::uint64_t id() const { return m_def.id; }

    /// The body's shape when its hull was last changed; it may be gone.
    const btCollisionShape* knownShape() const { return m_knownShape; }

    /// Made from what the last substep left. `frame`: the water's.
    BodyReport report(const WaterFrame& frame) const;

private:
    friend struct StateMembers;

    StepperDef stepperDef(const WaterNow& water) const {
        return {m_def.scheme, m_size, largestTurn, m_flexibility * water.field.density() * water.gravity};
    }
    bool staysAsleep(const WaterNow& water, bool reweighed);
    bool isStirred(const WaterNow& water) const;
    bool isInertiaKnown() const;
    bool isPlain() const;
    bool massHasChanged();
    void lookAtHull();
    void findFlexibility();
    bool shapeHasChanged() const;
    bool gravityActed() const;
    void arrive(const StepperDef& stepper, const WaterLoad& now, bool reweighed, double dt);
    void start(const StepperDef& stepper, const WaterLoad& now, bool gravity, double dt);
    bool wasHeld(double dt) const;
    Motion motionBefore(double dt) const;
    void keepAwakeUnlessAtRest(const WaterNow& water);
    bool isAtRest(double gravity) const;
    double length() const { return 2 * hull().bounds.radius; }

    btRigidBody* m_body;
    BodyDef m_def;
    BodyState m_state = BodyState::notStepped;
    bool m_hasMotion = false;  // it was stepped, and its motion is finite
    bool m_isPressed = false;  // there was gravity in the water in the last step
    bool m_wokenWithoutGravity = false;
    int m_waterSamples = 0;
    double m_size = 0;         // largest distance of a wetted point from the centre of mass, m
    double m_flexibility = 0;  // square of the fastest oscillation over the water's weight density, m^2/kg
    bool m_isPlain = false;    // by its settings, hull and inertia kernels may step it
    double m_inverseMass = 0;  // Bullet's
    Inertia m_inertia;
    Vec3 m_gravity = Vec3::Zero();  // Bullet's for the body, in the last step, m/s^2
    BorrowedSettings m_borrowed;
    Handover m_handover;
    BodyMotion m_motion;
    Vec3 m_lastSeenVelocity;  // while it was not stepped
    const btCollisionShape* m_knownShape = nullptr;
    btVector3 m_knownScaling{1, 1, 1};
};

}  // namespace bullet_buoyancy
