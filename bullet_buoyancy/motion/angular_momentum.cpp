#include "bullet_buoyancy/motion/angular_momentum.h"

#include <Eigen/Geometry>

#include "bullet_buoyancy/motion/damping.h"

namespace bullet_buoyancy {

RotationalInertia RotationalInertia::beforeTurning(const Vec3& spin, double dt) const {
    const double rate = spin.norm();
    if (rate == 0) return *this;
    return {Eigen::AngleAxisd(-rate * dt, spin / rate) * worldFromBody, principal};
}

void AngularMomentum::restart(const RotationalInertia& inertia, const Vec3& spin, double dt) {
    m_momentum = inertia.beforeTurning(spin, dt).momentum(spin);
    m_absorbed.setZero();
}

void AngularMomentum::absorb(const RotationalInertia& inertia, const Vec3& spin, double dt) {
    if (inertia.principal != m_handedInertia.principal) return restart(inertia, spin, dt);
    m_absorbed = m_handedInertia.momentum(spin - m_handedSpin);
    m_momentum += m_absorbed;
}

void AngularMomentum::step(const Vec3& torque, double dampingRate, double dt) {
    m_momentum = DampedStep(dampingRate, dt).advance(m_momentum, torque, m_absorbed / dt);
}

void AngularMomentum::lockAxes(const RotationalInertia& inertia, const Vec3& freeAxes) {
    m_momentum = inertia.momentum(inertia.spin(m_momentum).cwiseProduct(freeAxes));
}

void AngularMomentum::handOver(const RotationalInertia& inertia, const Vec3& spin) {
    m_handedInertia = inertia;
    m_handedSpin = spin;
}

}  // namespace bullet_buoyancy
