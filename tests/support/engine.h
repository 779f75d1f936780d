#pragma once

#include "bullet_buoyancy/motion/body_motion.h"
#include "bullet_buoyancy/motion/energy_guard.h"
#include "support/known_bodies.h"

namespace bullet_buoyancy::test {

/// A physics engine with one body: it moves the body at the velocity and spin that it is given.
class Engine {
public:
    Inertia inertia;
    StepperDef def;
    const LoadField& field;
    double dt;
    BodyMotion body;

    /// `fastest`: StepperDef::stiffestRate2, 1/s^2.
    Engine(const Inertia& itsInertia, const LoadField& itsField, double step, double fastest = 0)
        : inertia(itsInertia), field(itsField), dt(step) {
        def.stiffestRate2 = fastest;
    }

    void start(const Motion& motion) {
        body.start(motion);
        settle();
    }

    /// From one settled pose to the next, with an impulse (N s) and one of torque (N m s) on the way.
    void step(const Vec3& impulse = Vec3::Zero(), const Vec3& angularImpulse = Vec3::Zero()) {
        depart();
        if (impulse.isZero(0) && angularImpulse.isZero(0)) {
            body.arrive();
        } else {
            Disturbance blow;
            blow.velocityChange = inertia.velocityChange(impulse);
            blow.spinChange = inertia.spinChange(pose().orientation, angularImpulse);
            body.arriveElsewhere(inertia, movedAt(blow), blow);
        }
        settle();
    }

    /// Contacts stop whatever it does.
    void hold() {
        depart();
        Disturbance grip;
        grip.velocityChange = -body.departure().velocity;
        grip.spinChange = -body.departure().spin;
        body.arriveElsewhere(inertia, pose(), grip);
        settle();
    }

    void steps(int count) {
        for (int i = 0; i < count; ++i)
            step();
    }

    void depart() { body.depart(inertia, def, field, dt); }
    void settle() { body.settle(inertia, def, field, dt); }

    const Motion& motion() const { return body.motion(); }
    const Pose& pose() const { return motion().pose; }
    double height() const { return pose().position.z(); }
    double energy() const { return totalEnergy(motion(), inertia, body.load()); }

private:
    Pose movedAt(const Disturbance& blow) const {
        Motion motion = body.departure();
        motion.velocity += blow.velocityChange;
        motion.setSpin(inertia, motion.spin + blow.spinChange);
        return fly(motion, inertia, dt, turningOf(inertia, def.scheme), def.turnLimit).pose;
    }
};

}  // namespace bullet_buoyancy::test
