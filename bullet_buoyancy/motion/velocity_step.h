#pragma once

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/motion/damping.h"

namespace bullet_buoyancy {

/// What moves a body in a straight line during one step.
struct LinearLoad {
    Vec3 acceleration = Vec3::Zero();  ///< by all forces but gravity, drag, contacts and joints, m/s^2
    Vec3 gravity = Vec3::Zero();       ///< which the engine itself adds at the start of its next step, m/s^2
    double relief = 0;                 ///< share of these that contacts and joints take, see Relief
    double dragRate = 0;               ///< 1/s, relative to the medium
    Vec3 mediumVelocity = Vec3::Zero();  ///< m/s
};

struct VelocityStep {
    Vec3 forEngine;  ///< to set now: the engine's gravity brings it to the velocity of the step, m/s
    Vec3 atPose;     ///< at the moment of the pose, between the velocities before and after it, m/s
};

/// The velocity with which a body goes on from its pose, having arrived there with `arrival`: symplectic
/// Euler, with drag as in DampedStep. Afloat and at rest the velocity for the engine is -gravity dt.
inline VelocityStep stepVelocity(const Vec3& arrival, const LinearLoad& load, double dt) {
    const DampedStep damped(load.dragRate, dt);
    const Vec3 departure =
        load.mediumVelocity +
        damped.advance(arrival - load.mediumVelocity, load.acceleration + load.gravity, load.relief);
    return {departure - dt * load.gravity, (arrival + departure) / 2};
}

}  // namespace bullet_buoyancy
