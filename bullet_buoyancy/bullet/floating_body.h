#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/bullet/body_report.h"
#include "bullet_buoyancy/bullet/body_status.h"
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

    /// Takes the body's rotation over from Bullet. `def` must have a hull and have passed `check`.
    FloatingBody(btRigidBody& body, const BodyDef& def);

    /// Gives the body's angular damping and gyroscopic flags back as they came.
    void giveBack();

    /// One substep of `dt` > 0 (s), after Bullet has moved the body.
    void step(const WaterNow& water, double dt);

    /// The body is not touched, for this reason.
    void skip(BodyState reason) { m_report.state = reason; }

    const btRigidBody& body() const { return *m_body; }
    const Hull& hull() const { return *m_def.hull; }
    const BodyReport& report() const { return m_report; }

private:
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

    bool staysAsleep(const WaterNow& water) const;
    Wetness wetness(double submergedVolume) const;
    Owed owed(double dt);
    Vec3 accelerationByOthers(double dt) const;
    double stepTranslation(const Substep& substep);
    double stepRotation(const Substep& substep);
    double stepBulletsRotation(const Substep& substep);
    void keepAwakeWhileMoving(const WaterNow& water, double kineticEnergy);
    void writeReport(const Substep& substep, double kineticEnergy);

    btRigidBody* m_body;
    BodyDef m_def;
    double m_borrowedAngularDamping;
    int m_borrowedGyroscopicFlags;
    AngularMomentum m_momentum;
    Vec3 m_handedVelocity = Vec3::Zero();  // m/s, as Bullet was given it
    bool m_wokenWithoutGravity = false;
    BodyReport m_report;
};

}  // namespace bullet_buoyancy
