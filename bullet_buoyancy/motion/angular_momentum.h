#pragma once

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/motion/damping.h"

namespace bullet_buoyancy {

/// The most by which the engine turns a body in a step, whatever its spin (Bullet: ANGULAR_MOTION_THRESHOLD),
/// rad.
inline constexpr double largestTurn = pi / 4;

/// How a body's spin follows from its angular momentum L, in world axes, about its centre of mass:
/// L = R I R^T omega, with I the principal moments of inertia along the body's axes and R body to world.
struct RotationalInertia {
    Mat3 worldFromBody = Mat3::Identity();
    Vec3 principal = Vec3::Ones();  ///< kg m^2, above zero

    Vec3 momentum(const Vec3& spin) const {
        return worldFromBody * principal.cwiseProduct(worldFromBody.transpose() * spin);
    }
    Vec3 spin(const Vec3& momentum) const {
        return worldFromBody * (worldFromBody.transpose() * momentum).cwiseQuotient(principal);
    }

    /// Before the engine turned the body by `spin` (rad/s) for `dt` (s).
    RotationalInertia beforeTurning(const Vec3& spin, double dt) const;
};

/// The owner of a body's angular momentum. The momentum is the state, kept in double precision; the engine's
/// angular velocity follows from it, and what others do to that velocity in between enters the momentum as an
/// impulse.
///
/// Each step: `absorb` (or `restart`), `step`, `handOver`.
class AngularMomentum {
public:
    /// kg m^2/s, world axes
    const Vec3& value() const { return m_momentum; }

    /// Forgets the past. The engine has turned the body by `spin` (rad/s, world axes) for `dt` (s) to where
    /// it is now: its momentum is that of the spin at the orientation before.
    void restart(const RotationalInertia& inertia, const Vec3& spin, double dt);

    /// Takes in what contacts, joints and the user did since `handOver`. They acted at the orientation of
    /// that moment: engines solve for velocities before they turn the body. If that orientation or the
    /// principal moments have been changed since, this is a restart at the same spin.
    void absorb(const RotationalInertia& inertia, const Vec3& spin, double dt);

    /// kg m^2/s, world axes
    void addImpulse(const Vec3& impulse) { m_momentum += impulse; }

    /// Adds `torque` (N m) for the step and damps, see DampedStep. Returns the share of the torque that
    /// others take.
    double step(const Vec3& torque, double dampingRate, double dt);

    /// Notes the spin that the engine was given, as it was rounded, and the orientation it will be solved at.
    void handOver(const RotationalInertia& inertia, const Vec3& spin);

private:
    bool wasTurnedByHand(const RotationalInertia& inertia, const Vec3& spin, double dt) const;

    Vec3 m_momentum = Vec3::Zero();
    Vec3 m_absorbed = Vec3::Zero();  // by the last call of absorb
    Relief m_relief;
    RotationalInertia m_handedInertia;
    Vec3 m_handedSpin = Vec3::Zero();
};

}  // namespace bullet_buoyancy
