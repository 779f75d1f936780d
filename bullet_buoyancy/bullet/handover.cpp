#include "bullet_buoyancy/bullet/handover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/core/fill_rows.h"
#include "bullet_buoyancy/motion/free_rotation.h"

namespace bullet_buoyancy {

namespace {

/// Bullet rounds its numbers to this share of themselves, a few times on the way through a step.
constexpr double rounding = std::numeric_limits<btScalar>::epsilon();

/// Square of twice the sine of half the angle between two orientations, rad^2 where it is small.
double squaredAngle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    if (a.coeffs() == b.coeffs()) return 0;
    return 4 * (a.conjugate() * b).vec().squaredNorm();
}

constexpr double square(double x) {
    return x * x;
}

/// Where Bullet's pose has come to lie off ours by more than it rounds, it is brought back.
Vec3 correction(const Vec3& ours, const Vec3& bullets) {
    const Vec3 difference = ours - bullets;
    const double tolerance = 2 * rounding * (bullets.cwiseAbs().maxCoeff() + 1e-3);
    return difference.cwiseAbs().maxCoeff() > tolerance ? difference : Vec3::Zero();
}

/// What others took of a correction was never the body's.
Vec3 stopped(const Vec3& correction, const Vec3& change) {
    const double square = correction.squaredNorm(), taken = -change.dot(correction);
    return taken > 0 ? Vec3(std::min(1.0, taken / square) * correction) : Vec3::Zero();
}

/// Bullet's pose, with the orientation that is meant if that is what it rounds to: the usual case is a quick
/// one.
Pose poseNear(const Pose& target, const btTransform& transform) {
    const Mat3 axes = target.orientation.toRotationMatrix();
    double difference = 0;
    for (int row = 0; row < 3; ++row)
        difference =
            std::max(difference,
                     (toEigen(transform.getBasis()[row]) - axes.row(row).transpose()).cwiseAbs().maxCoeff());
    if (!(difference <= 4 * rounding)) return toPose(transform);
    return {toEigen(transform.getOrigin()), target.orientation};
}

Vec3 gravityStep(const btRigidBody& body, double dt) {
    return dt * toEigen(body.getGravity()).cwiseProduct(toEigen(body.getLinearFactor()));
}

}  // namespace

double Handover::longestStep(double dt) const {
    constexpr double forgetting = 0.99;  // a step
    return std::max(dt, forgetting * m_longestStep);
}

double Handover::lag(const Pose& ours) const {
    const double angle2 = squaredAngle(ours.orientation, m_pose.orientation);
    return angle2 <= square(64 * rounding) ? 0 : 2 * std::asin(std::min(1.0, std::sqrt(angle2) / 2));
}

void Handover::give(btRigidBody& body, const BodyMotion& motion, Turning turning, double dt) {
    const Pose& ours = motion.motion().pose;
    m_longestStep = longestStep(dt);
    m_correction = correction(ours.position, m_pose.position) * (1 / m_longestStep);
    const Vec3 velocity = motion.departure().velocity + m_correction;
    const bool turnedOff = squaredAngle(ours.orientation, m_pose.orientation) > square(4 * rounding);
    const Eigen::Quaterniond& from = turnedOff ? m_pose.orientation : ours.orientation;
    const Vec3 spin = turnedOff || turning == Turning::byMomentum
                          ? Vec3(rotationVector(motion.target().orientation * from.conjugate()) * (1 / dt))
                          : motion.departure().spin;
    const double turn2 = spin.squaredNorm() * dt * dt;  // past the limit where Bullet's pose lags behind ours
    const bool isLimited = turn2 > square(largestTurn);
    m_velocity = toBullet(velocity - gravityStep(body, dt));
    m_spin = toBullet(isLimited ? Vec3(largestTurn / std::sqrt(turn2) * spin) : spin);
    body.setLinearVelocity(m_velocity);
    body.setAngularVelocity(m_spin);
    m_start = m_pose;
    m_dt = dt;
}

void Handover::put(const btRigidBody& body, ReturnRows& returns, int lane) const {
    const btTransform& transform = body.getWorldTransform();
    for (int row = 0; row < 3; ++row)
        bullet_buoyancy::put(toEigen(transform.getBasis()[row]), returns.axes[row], lane);
    bullet_buoyancy::put(toEigen(transform.getOrigin()), returns.position, lane);
    bullet_buoyancy::put(toEigen(body.getLinearVelocity()), returns.velocity, lane);
    bullet_buoyancy::put(toEigen(m_velocity), returns.given, lane);
    bullet_buoyancy::put(toEigen(body.getTotalForce()), returns.force, lane);
    bullet_buoyancy::put(toEigen(body.getGravity()), returns.gravity, lane);
    returns.inverseMass.lane[lane] = double(body.getInvMass());
    returns.longestStep.lane[lane] = longestStep(m_dt);
}

void Handover::prepare(const btRigidBody& body, const Pose& target, const GiftRows& gifts, int lane,
                       double dt) {
    const VectorRows &velocity = gifts.velocity, &spin = gifts.spin;
    m_velocity.setValue(btScalar(velocity.x.lane[lane]), btScalar(velocity.y.lane[lane]),
                        btScalar(velocity.z.lane[lane]));
    m_spin.setValue(btScalar(spin.x.lane[lane]), btScalar(spin.y.lane[lane]), btScalar(spin.z.lane[lane]));
    get(gifts.correction, lane, m_correction);
    m_longestStep = longestStep(dt);
    m_pose = {toEigen(body.getWorldTransform().getOrigin()), target.orientation};
    m_start = {toEigen(body.getWorldTransform().getOrigin()), target.orientation};
    m_dt = dt;
}

void Handover::giveAsPrepared(btRigidBody& body) const {
    body.setLinearVelocity(m_velocity);
    body.setAngularVelocity(m_spin);
}

Return Handover::take(const btRigidBody& body, const Pose& target, double dt, bool gravityActed) {
    m_pose = poseNear(target, body.getWorldTransform());
    m_disturbance.velocityChange = velocityChange(body, dt, gravityActed);
    m_disturbance.spinChange = toEigen(body.getAngularVelocity() - m_spin);
    m_disturbance.turnedByHand = false;
    const bool pushed = !m_disturbance.velocityChange.isZero(0) || !m_disturbance.spinChange.isZero(0);
    if (!pushed && dt == m_dt && gravityActed && isAt(target, body)) return Return::atTarget;
    const Vec3 displacement = m_pose.position - m_start.position;
    const bool isMoved =
        (displacement - dt * toEigen(body.getLinearVelocity())).norm() > positionTolerance(body);
    m_disturbance.turnedByHand = !isWhereItsSpinLeads(body, dt);
    return pushed || isMoved || m_disturbance.turnedByHand ? Return::disturbed : Return::astray;
}

/// By others: contacts, joints, impulses, and forces that the user applies beside gravity.
Vec3 Handover::velocityChange(const btRigidBody& body, double dt, bool gravityActed) const {
    const btScalar inverseMass = body.getInvMass();
    const btVector3 external = body.getTotalForce() * inverseMass * btScalar(dt);
    Vec3 change = toEigen(body.getLinearVelocity() - (m_velocity + external));
    const double scale = toEigen(m_velocity).cwiseAbs().maxCoeff() + toEigen(external).cwiseAbs().maxCoeff();
    if (change.cwiseAbs().maxCoeff() <= 4 * rounding * scale)
        change.setZero();
    else
        change += stopped(m_correction, change);
    if (!gravityActed) return change;
    const Vec3 ofGravity = gravityStep(body, dt), byUser = toEigen(external) - ofGravity;
    const bool isRounding = byUser.cwiseAbs2().maxCoeff() <= square(8 * rounding) * ofGravity.squaredNorm();
    return isRounding ? change : Vec3(change + byUser);
}

/// Of Bullet's numbers in the sum of a position and a step, m.
double Handover::positionTolerance(const btRigidBody& body) const {
    const double travel = toEigen(body.getLinearVelocity()).cwiseAbs().sum() * m_dt;
    return 8 * rounding * (m_pose.position.cwiseAbs().maxCoeff() + travel + 1e-3);
}

bool Handover::isAt(const Pose& target, const btRigidBody& body) const {
    return (m_pose.position - target.position).cwiseAbs().maxCoeff() <= positionTolerance(body) &&
           squaredAngle(m_pose.orientation, target.orientation) <= square(64 * rounding);
}

bool Handover::isWhereItsSpinLeads(const btRigidBody& body, double dt) const {
    constexpr double tolerance = 1e-3;  // far above rounding, and what Bullet turns bodies out of each other
    const Vec3 spin = toEigen(body.getAngularVelocity());
    const double rate = spin.norm();
    if (rate * dt > largestTurn)
        return true;  // Bullet's own shortening of the turn is not told from a hand's
    const Eigen::Quaterniond turn = rate > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(rate * dt, spin / rate))
                                             : Eigen::Quaterniond::Identity();
    return squaredAngle(turn * m_start.orientation, m_pose.orientation) <= square(tolerance);
}

}  // namespace bullet_buoyancy
