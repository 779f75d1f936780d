#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/bullet/body_report.h"
#include "bullet_buoyancy/bullet/body_status.h"
#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/hydrostatics/hydrostatics.h"
#include "bullet_buoyancy/motion/angular_momentum.h"

namespace bullet_buoyancy {

/// The water as it meets the bodies in one substep.
struct WaterNow {
    const WaterField& field;
    WaterBounds bounds;
    double gravity;  ///< of the world, along the water frame's down, m/s^2
    double time;     ///< s
};

/// One rigid body in the care of the action: what was borrowed from Bullet, the momentum that is its state,
/// and what was last reported.
class FloatingBody {
public:
    /// Checks body and settings; changes nothing.
    static BodyStatus check(const btRigidBody& body, const BodyDef& def);

    /// Takes the body's damping and rotation over from Bullet, and wakes it. `def` must have a hull and have
    /// passed `check`.
    FloatingBody(btRigidBody& body, const BodyDef& def);

    /// Gives the body's damping and gyroscopic flags back as they came, and wakes it.
    void giveBack();

    /// One substep of `dt` > 0 (s), after Bullet has moved the body.
    void step(const WaterNow& water, double dt);

    /// The body is not touched, for this reason.
    void skip(BodyState reason);

    const btRigidBody& body() const { return *m_body; }
    const Hull& hull() const { return *m_def.hull; }
    const BodyReport& report() const { return m_report; }

private:
    /// What is Bullet's while the body is not ours.
    struct Borrowed {
        double linearDamping = 0, angularDamping = 0;  // Bullet's: share lost in a second
        int gyroscopicFlags = 0;
    };

    /// How much of the body is wet, and at which rates (1/s) that slows it.
    struct Wetness {
        double fraction, dragRate, dampingRate;
    };

    /// Times (s) for which forces have yet to act that Bullet or the action left out.
    struct Owed {
        double byWater, byGravity;
    };

    struct Substep {
        const WaterNow& water;
        double dt;
        Pose pose;
        HydrostaticResult pressure;
        Wetness wet;
        Owed owed;
    };

    /// How the body moves at the pose, between the substeps before and after it.
    struct Motion {
        Vec3 velocity = Vec3::Zero();  // m/s
        double kineticEnergy = 0;      // J
        double acceleration = 0;       // by forces that do not balance, m/s^2
        double torque = 0;             // that does not balance, N m
    };

    void borrow();
    bool staysAsleep(const WaterNow& water);
    bool massHasChanged();
    Wetness wetness(double submergedVolume) const;
    Owed owed(double dt);
    Vec3 accelerationByOthers(double dt) const;
    void stepTranslation(const Substep& substep, Motion& motion);
    void stepRotation(const Substep& substep, Motion& motion);
    void stepRestrictedRotation(const Substep& substep, Motion& motion);
    void keepAwakeUnlessAtRest(const WaterNow& water, const Motion& motion);
    void writeReport(const Substep& substep, const Motion& motion);

    btRigidBody* m_body;
    BodyDef m_def;
    Borrowed m_borrowed;
    AngularMomentum m_momentum;
    Relief m_relief;
    Vec3 m_handedVelocity = Vec3::Zero();  // m/s, as Bullet was given it
    Vec3 m_knownInverseInertia = Vec3::Zero();
    double m_knownInverseMass = 0;
    bool m_wokenWithoutGravity = false;
    BodyReport m_report;
};

}  // namespace bullet_buoyancy
