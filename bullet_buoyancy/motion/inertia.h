#pragma once

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy {

/// The largest angle by which the engine turns a body in a step as its spin says (Bullet:
/// ANGULAR_MOTION_THRESHOLD), rad.
inline constexpr double largestTurn = pi / 4;

/// How a body answers to impulses.
struct Inertia {
    double mass = 1;                       ///< kg
    Vec3 principal = Vec3::Ones();         ///< moments along the body's axes, kg m^2; 0: cannot be turned
    Vec3 inversePrincipal = Vec3::Ones();  ///< 1/(kg m^2); 0: cannot be turned
    Vec3 linearFactor = Vec3::Ones();      ///< share of an impulse that moves the body, along world axes
    Vec3 angularFactor = Vec3::Ones();     ///< likewise about world axes

    /// Otherwise torques that nobody knows of hold the body about some axis. Its angular momentum then says
    /// nothing, and it turns as the engine turns it: at its spin.
    bool turnsFreely = true;

    Vec3 velocityChange(const Vec3& impulse) const { return impulse.cwiseProduct(linearFactor) * (1 / mass); }

    /// Angular, of a spin (rad/s), both in world axes: L = R I R^T omega, with I the principal moments and R
    /// the orientation, body to world. kg m^2/s.
    Vec3 momentum(const Eigen::Quaterniond& orientation, const Vec3& spin) const {
        const Mat3 axes = orientation.toRotationMatrix();
        return axes * principal.cwiseProduct(axes.transpose() * spin);
    }
    Vec3 spin(const Eigen::Quaterniond& orientation, const Vec3& momentum) const {
        const Mat3 axes = orientation.toRotationMatrix();
        return axes * inversePrincipal.cwiseProduct(axes.transpose() * momentum);
    }
    /// By an impulse of torque (N m s).
    Vec3 spinChange(const Eigen::Quaterniond& orientation, const Vec3& impulse) const {
        return turnsFreely
                   ? spin(orientation, impulse)
                   : spin(orientation, impulse.cwiseProduct(angularFactor)).cwiseProduct(angularFactor);
    }
};

}  // namespace bullet_buoyancy
