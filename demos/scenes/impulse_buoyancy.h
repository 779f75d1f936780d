#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <vector>

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/bullet/body_report.h"
#include "bullet_buoyancy/bullet/body_status.h"
#include "bullet_buoyancy/water/water_field.h"

class btRigidBody;

namespace bullet_buoyancy::scenes {

/// Buoyancy as most engines have it, for comparison: each substep the force and torque of the water at the
/// body's pose, exactly evaluated, are applied as impulses, and drag and angular damping take rate dt of the
/// velocities (explicit Euler). Rotation, with its gyroscopic term, is Bullet's own.
///
/// Bodies and water must outlive it.
class ImpulseBuoyancy : public btActionInterface {
public:
    explicit ImpulseBuoyancy(const WaterField& water) : m_water(&water) {}

    /// Refuses only bodies without a hull.
    BodyStatus addBody(btRigidBody& body, const BodyDef& def);

    /// State, velocity, wet fraction, displacement and energies, as `BodyReport` has them.
    BodyReport report(const btRigidBody& body) const;

    void updateAction(btCollisionWorld* world, btScalar dt) override;
    void debugDraw(btIDebugDraw*) override {}

private:
    struct Floating {
        btRigidBody* body;
        BodyDef def;
        BodyReport report;
    };

    void step(Floating& floating, double gravity, double dt) const;

    const WaterField* m_water;
    std::vector<Floating> m_bodies;
};

}  // namespace bullet_buoyancy::scenes
