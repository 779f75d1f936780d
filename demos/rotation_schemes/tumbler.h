#pragma once

#include <Eigen/Geometry>
#include <limits>

namespace bullet_buoyancy::demo {

/// A body on which no torque acts: its orientation, body to world, and its angular momentum in its own
/// principal axes, kg m^2/s.
template <typename Real>
struct TumblerOf {
    using Vector = Eigen::Matrix<Real, 3, 1>;
    using Quaternion = Eigen::Quaternion<Real>;

    Quaternion orientation = Quaternion::Identity();
    Vector momentum = Vector::Zero();

    /// By a rotation in its own axes. The momentum stays at rest in the world.
    void turn(const Quaternion& rotation) {
        orientation = (orientation * rotation).normalized();
        momentum = rotation.conjugate() * momentum;
    }
};

using Tumbler = TumblerOf<double>;

/// One step by the Taylor series of the momentum and of the orientation, up to the term that rounding
/// swallows. Both rates are products, so that every coefficient follows from those before it.
template <typename Real>
void turnByTaylorSeries(const Eigen::Matrix<Real, 3, 1>& principal, TumblerOf<Real>& body, Real dt) {
    using Vector = typename TumblerOf<Real>::Vector;
    using Quaternion = typename TumblerOf<Real>::Quaternion;
    constexpr int most = 60;
    constexpr Real rounding = std::numeric_limits<Real>::epsilon() / 4;

    Vector momentum[most + 1], halfSpin[most + 1];
    Quaternion orientation[most + 1];
    momentum[0] = body.momentum;
    halfSpin[0] = dt / 2 * momentum[0].cwiseQuotient(principal);
    orientation[0] = Quaternion::Identity();
    Vector sumOfMomenta = momentum[0];
    auto sumOfOrientations = orientation[0].coeffs();
    Real last = 1, term = 1;
    for (int k = 0; k < most && (last > rounding || term > rounding); ++k) {
        Vector rate = Vector::Zero(), turn = Vector::Zero();
        Real scalar = 0;
        for (int j = 0; j <= k; ++j) {
            rate += 2 * momentum[j].cross(halfSpin[k - j]);
            turn += orientation[j].w() * halfSpin[k - j] + orientation[j].vec().cross(halfSpin[k - j]);
            scalar -= orientation[j].vec().dot(halfSpin[k - j]);
        }
        const Real share = 1 / Real(k + 1);
        momentum[k + 1] = share * rate;
        halfSpin[k + 1] = dt / 2 * momentum[k + 1].cwiseQuotient(principal);
        orientation[k + 1].w() = share * scalar;
        orientation[k + 1].vec() = share * turn;
        sumOfMomenta += momentum[k + 1];
        sumOfOrientations += orientation[k + 1].coeffs();
        last = term;
        term = orientation[k + 1].norm() + halfSpin[k + 1].norm();
    }
    body.orientation = (body.orientation * Quaternion(sumOfOrientations)).normalized();
    body.momentum = sumOfMomenta;
}

}  // namespace bullet_buoyancy::demo
