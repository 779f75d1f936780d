#include "rotation_schemes/schemes.h"

#include <cmath>

#include "bullet_buoyancy/motion/free_rotation.h"

namespace bullet_buoyancy::demo {

namespace {

using Eigen::Quaterniond;

Quaterniond turnBy(const Vec3& rotationVector) {
    const double angle = rotationVector.norm();
    if (angle == 0) return Quaterniond::Identity();
    return Quaterniond(Eigen::AngleAxisd(angle, rotationVector / angle));
}

Quaterniond turnByHalfTangents(const Vec3& tangents) {
    return Quaterniond(1, tangents.x(), tangents.y(), tangents.z()).normalized();
}

Mat3 crossing(const Vec3& v) {
    Mat3 matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

/// The momentum is kept, the spin is that at the start of the step.
void stepByFirstSpin(const Vec3& principal, Tumbler& body, double dt) {
    body.turn(turnBy(dt * body.momentum.cwiseQuotient(principal)));
}

/// Bullet's default (Catto, Numerical Methods, GDC 2015): one Newton step for the implicit Euler method in
/// the body's axes, whose spin then turns the body.
void stepLikeBullet(const Vec3& principal, Tumbler& body, double dt) {
    const Mat3 inertia = principal.asDiagonal();
    const Vec3 spin = body.momentum.cwiseQuotient(principal);
    const Vec3 residual = dt * spin.cross(body.momentum);
    const Mat3 jacobian = inertia + dt * (crossing(spin) * inertia - crossing(body.momentum));
    const Vec3 newSpin = spin - jacobian.inverse() * residual;
    body.orientation = (body.orientation * turnBy(dt * newSpin)).normalized();
    body.momentum = principal.cwiseProduct(newSpin);
}

/// The rotations about each axis alone are exact. Strang's symmetric order of them is of second order.
void stepByFiveRotations(const Vec3& principal, Tumbler& body, double dt) {
    const auto turnAbout = [&](int axis, double time) {
        const double half = time / 2 * body.momentum[axis] / principal[axis];
        Quaterniond rotation(std::cos(half), 0, 0, 0);
        rotation.vec()[axis] = std::sin(half);
        body.turn(rotation);
    };
    turnAbout(0, dt / 2);
    turnAbout(1, dt / 2);
    turnAbout(2, dt);
    turnAbout(1, dt / 2);
    turnAbout(0, dt / 2);
}

/// Solves I g + g x I g = dt / 2 L (1 + stretch |g|^2) for g, the tangents of half the angles.
Vec3 solveForHalfTangents(const Vec3& principal, const Vec3& momentum, double dt, double stretch) {
    constexpr int most = 100;
    constexpr double rounding = 1e-16;
    const Vec3 start = dt / 2 * momentum;
    Vec3 tangents = start.cwiseQuotient(principal);
    for (int i = 0; i < most; ++i) {
        const Vec3 next = ((1 + stretch * tangents.squaredNorm()) * start -
                           tangents.cross(principal.cwiseProduct(tangents)))
                              .cwiseQuotient(principal);
        const double change = (next - tangents).squaredNorm();
        tangents = next;
        if (change <= rounding * rounding) break;
    }
    return tangents;
}

void stepByImplicitMidpoint(const Vec3& principal, Tumbler& body, double dt) {
    body.turn(turnByHalfTangents(solveForHalfTangents(principal, body.momentum, dt, 0)));
}

/// Moser and Veselov, Commun. Math. Phys. 139, 1991: the midpoint rule with its time stretched (McLachlan and
/// Zanna, Found. Comput. Math. 5, 2005).
void stepByMoserVeselov(const Vec3& principal, Tumbler& body, double dt) {
    body.turn(turnByHalfTangents(solveForHalfTangents(principal, body.momentum, dt, 1)));
}

/// The same with moments changed so that it is of fourth order (Hairer and Vilmart, J. Phys. A 39, 2006): by
/// the terms in dt^2 of the change that makes it exact.
void stepByPreprocessedMoserVeselov(const Vec3& principal, Tumbler& body, double dt) {
    const Vec3 spin = body.momentum.cwiseQuotient(principal), squares = spin.cwiseAbs2();
    const double x = principal.x(), y = principal.y(), z = principal.z();
    const Vec3 a((y - z) / x, (z - x) / y, (x - y) / z);
    const double c =
        (a.y() * a.z() * squares.x() + a.z() * a.x() * squares.y() + a.x() * a.y() * squares.z()) / 3;
    const double square = dt * dt / 4;
    const double stretch = 1 + square * (squares.sum() + c);
    const double shift = square / 3 *
                         (principal.sum() * spin.dot(body.momentum) - 2 * body.momentum.squaredNorm()) /
                         principal.prod();
    const Vec3 changed = stretch * (principal.cwiseInverse() + Vec3::Constant(shift)).cwiseInverse();
    body.turn(turnByHalfTangents(solveForHalfTangents(changed, body.momentum, dt, 1)));
}

void stepByTaylorSeries(const Vec3& principal, Tumbler& body, double dt) {
    turnByTaylorSeries<double>(principal, body, dt);
}

void stepByOurs(const Vec3& principal, Tumbler& body, double dt) {
    body.turn(turnFreely(principal, body.momentum, dt));
}

}  // namespace

const std::vector<Scheme>& schemes() {
    static const std::vector<Scheme> all{
        {"spin at the start of the step", stepByFirstSpin},
        {"Bullet's implicit gyroscopic step", stepLikeBullet},
        {"implicit midpoint", stepByImplicitMidpoint},
        {"five rotations (Strang)", stepByFiveRotations},
        {"discrete Moser-Veselov", stepByMoserVeselov},
        {"the same, preprocessed to order 4", stepByPreprocessedMoserVeselov},
        {"Taylor series to rounding", stepByTaylorSeries},
        {"turnFreely", stepByOurs}};
    return all;
}

const Scheme& ours() {
    return schemes().back();
}

}  // namespace bullet_buoyancy::demo
