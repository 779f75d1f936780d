#include "bullet_buoyancy/motion/angular_momentum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

RotationalInertia RotationalInertia::beforeTurning(const Vec3& spin, double dt) const {
    const double rate = spin.norm();
    if (rate == 0) return *this;
    const double angle = std::min(rate * dt, largestTurn);
    return {Eigen::AngleAxisd(-angle, spin / rate) * worldFromBody, principal};
}

/// Whether the angle from the orientation handed over to that of now is not the one by which the engine
/// turned the body: told from the norm of the difference of two rotations by an angle, 2 sqrt 2 sin(angle /
/// 2).
bool AngularMomentum::wasTurnedByHand(const RotationalInertia& inertia, const Vec3& spin, double dt) const {
    constexpr double tolerance = 1e-3;  // far above the rounding of the engine's orientations
    const double difference = (inertia.worldFromBody - m_handedInertia.worldFromBody).norm();
    const double angle = std::min(spin.norm() * dt, largestTurn);
    const double expected = 2 * std::sqrt(2.0) * std::sin(angle / 2);
    return std::abs(difference - expected) > tolerance;
}

void AngularMomentum::restart(const RotationalInertia& inertia, const Vec3& spin, double dt) {
    m_momentum = inertia.beforeTurning(spin, dt).momentum(spin);
    m_absorbed.setZero();
    m_relief.restart();
}

void AngularMomentum::absorb(const RotationalInertia& inertia, const Vec3& spin, double dt) {
    if (inertia.principal != m_handedInertia.principal || wasTurnedByHand(inertia, spin, dt))
        return restart(inertia, spin, dt);
    m_absorbed = m_handedInertia.momentum(spin - m_handedSpin);
    m_momentum += m_absorbed;
}

double AngularMomentum::step(const Vec3& torque, double dampingRate, double dt) {
    const double relief = m_relief.update(torque, m_absorbed / dt);
    m_momentum = DampedStep(dampingRate, dt).advance(m_momentum, torque, relief);
    return relief;
}

void AngularMomentum::handOver(const RotationalInertia& inertia, const Vec3& spin) {
    m_handedInertia = inertia;
    m_handedSpin = spin;
}

}  // namespace bullet_buoyancy
