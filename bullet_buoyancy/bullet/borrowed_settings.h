#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet_buoyancy/bullet/precision.h"

namespace bullet_buoyancy {

/// What Bullet would do to a body's velocities by itself, and does not while the body is ours: its damping
/// and its gyroscopic forces.
class BorrowedSettings {
public:
    /// Again in each step, so that what the user sets in the meantime is what he gets back.
    void borrow(btRigidBody& body);

    /// Whether there is nothing to borrow: the user has set nothing since.
    bool isAll(const btRigidBody& body) const;

    void giveBack(btRigidBody& body) const;

    /// The rate (1/s) at which Bullet would slow the body, towards rest in the world.
    double linearDampingRate() const { return m_linearDampingRate; }

private:
    friend struct StateMembers;

    double m_linearDamping = 0, m_angularDamping = 0;  // Bullet's: share lost in a second
    double m_linearDampingRate = 0;
    int m_gyroscopicFlags = 0;
};

}  // namespace bullet_buoyancy
