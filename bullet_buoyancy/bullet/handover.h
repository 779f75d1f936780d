#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet_buoyancy/bullet/handover_kernels.h"
#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/motion/body_motion.h"

namespace bullet_buoyancy {

/// How a body comes back from Bullet's step.
enum class Return {
    atTarget,  ///< to the rounding of Bullet's numbers
    astray,  ///< where its velocities led in a step of another length, without gravity, or with too much spin
    disturbed,  ///< others acted on it
};

/// What Bullet was given of a body's motion, and what it made of it.
class Handover {
public:
    /// Sets the velocities with which Bullet, adding gravity, takes the body to the target of `motion` in a
    /// step of `dt` (s).
    void give(btRigidBody& body, const BodyMotion& motion, Turning turning, double dt);

    /// After Bullet's step of `dt` (s). `target`: of the motion that was given. `gravityActed`: Bullet leaves
    /// it out after a body has been woken.
    Return take(const btRigidBody& body, const Pose& target, double dt, bool gravityActed);

    /// Whether a body that comes from a step of `dt` (s) turns at the spin that it was given for such a step.
    bool isAsGiven(const btRigidBody& body, double dt) const {
        return dt == m_dt && body.getAngularVelocity() == m_spin;
    }

    /// What the kernels take of a body that is as given.
    void put(const btRigidBody& body, ReturnRows& returns, int lane) const;

    /// `give` as the kernels found it, in two parts, of a body that came back at its target. The second waits
    /// for the first to be stored: best with something in between.
    void prepare(const btRigidBody& body, const Pose& target, const GiftRows& gifts, int lane, double dt);
    void giveAsPrepared(btRigidBody& body) const;

    /// The angle by which Bullet's body has yet to be turned to reach a pose of ours, rad.
    double lag(const Pose& ours) const;

    /// Of the step for which the velocities were given, s.
    double dt() const { return m_dt; }

    /// In Bullet's precision.
    const Pose& pose() const { return m_pose; }
    const Disturbance& disturbance() const { return m_disturbance; }

private:
    friend struct StateMembers;

    Vec3 velocityChange(const btRigidBody& body, double dt, bool gravityActed) const;
    double positionTolerance(const btRigidBody& body) const;
    bool isAt(const Pose& target, const btRigidBody& body) const;
    double longestStep(double dt) const;
    bool isWhereItsSpinLeads(const btRigidBody& body, double dt) const;

    btVector3 m_velocity{0, 0, 0}, m_spin{0, 0, 0};  // as given
    Vec3 m_correction = Vec3::Zero();  // the part of the velocity that only moves Bullet's body to ours
    Pose m_start;                      // of Bullet's
    double m_dt = 0;
    double m_longestStep =
        0;  // lately: where steps vary, a correction meant for a short one would overshoot, s
    Pose m_pose;
    Disturbance m_disturbance;
};

}  // namespace bullet_buoyancy
