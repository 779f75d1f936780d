#pragma once

#include <functional>

#include "bullet_buoyancy/motion/body_motion.h"
#include "bullet_buoyancy/motion/energy_guard.h"
#include "support/known_bodies.h"
#include "support/simple_loads.h"

namespace bullet_buoyancy::test {

/// A physics engine with one body under a load that moves.
class MovingEngine {
public:
    Inertia inertia;
    StepperDef def;
    std::function<Vec3(double)> place;  ///< of the load at a time (s), m
    double weight = 0;                  ///< of the body, N
    double time = 0;                    ///< s
    BodyMotion body;

    /// `fastest`: StepperDef::stiffestRate2, 1/s^2.
    MovingEngine(const Inertia& itsInertia, const LoadField& load, std::function<Vec3(double)> itsPlace,
                 double fastest = 0)
        : inertia(itsInertia), place(std::move(itsPlace)), m_load(load) {
        def.stiffestRate2 = fastest;
    }

    MovedLoad loadAt(double when) const { return {m_load, place(when), weight}; }

    void start(const Motion& motion, double dt) {
        body.start(motion);
        settle(dt);
    }

    void step(double dt) {
        depart(dt);
        body.arrive();
        time += dt;
        settle(dt);
    }

    void depart(double dt) { body.depart(inertia, def, loadAt(time + dt), dt); }
    void settle(double dt) { body.settle(inertia, def, loadAt(time), dt); }

    const Motion& motion() const { return body.motion(); }
    const Pose& pose() const { return motion().pose; }
    double height() const { return pose().position.z(); }
    double energy() const { return totalEnergy(motion(), inertia, body.load()); }

private:
    const LoadField& m_load;
};

/// Up and down, as a tide: `amplitude` (m) times the sine of `omega` (rad/s) times the time.
inline std::function<Vec3(double)> heaving(double amplitude, double omega) {
    return [=](double time) { return Vec3(0, 0, amplitude * std::sin(omega * time)); };
}

}  // namespace bullet_buoyancy::test
