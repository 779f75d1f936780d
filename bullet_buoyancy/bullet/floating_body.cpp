#include "bullet_buoyancy/bullet/floating_body.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/hydrodynamics/wet_rate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/motion/energy.h"
#include "bullet_buoyancy/motion/rest.h"
#include "bullet_buoyancy/motion/velocity_step.h"

namespace bullet_buoyancy {

namespace {

constexpr int gyroscopicFlags = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

bool isFinite(const btRigidBody& body) {
    const btTransform& transform = body.getWorldTransform();
    Vec3 sum = toEigen(transform.getOrigin()) + toEigen(body.getLinearVelocity()) +
               toEigen(body.getAngularVelocity()) + toEigen(body.getInvInertiaDiagLocal()) +
               Vec3::Constant(double(body.getInvMass()));
    for (int row = 0; row < 3; ++row)
        sum += toEigen(transform.getBasis()[row]);
    return sum.allFinite();  // NaN and infinity survive every sum
}

/// About every axis of its own.
bool hasInertia(const btRigidBody& body) {
    return toEigen(body.getInvInertiaDiagLocal()).minCoeff() > 0;
}

bool turnsFreely(const btRigidBody& body) {
    return hasInertia(body) && toEigen(body.getAngularFactor()) == Vec3::Ones();
}

Vec3 waterVelocityAt(const WaterField& field, const Vec3& pointWorld, double time) {
    const Vec3 point = field.frame().pointFromWorld(pointWorld);
    Vec3 velocity;
    field.sampleVelocity(Eigen::Map<const Eigen::ArrayX3d>(point.data(), 1, 3), time,
                         Eigen::Map<Eigen::ArrayX3d>(velocity.data(), 1, 3));
    return field.frame().worldFromFrame() * velocity;
}

BodyState stateOf(double wetFraction) {
    if (wetFraction <= 0) return BodyState::dry;
    return wetFraction < 1 ? BodyState::floating : BodyState::submerged;
}

bool wasStepped(BodyState state) {
    return state == BodyState::dry || state == BodyState::floating || state == BodyState::submerged;
}

bool isRate(double rate) {
    return std::isfinite(rate) && rate >= 0;
}

}  // namespace

BodyStatus FloatingBody::check(const btRigidBody& body, const BodyDef& def) {
    BodyStatus status;
    status.canTurn = hasInertia(body);
    if (!isFinite(body))
        status.error = BodyError::notFinite;
    else if (body.isStaticObject() || body.getInvMass() == 0)
        status.error = BodyError::staticBody;
    else if (body.isKinematicObject())
        status.error = BodyError::kinematicBody;
    else if (!isRate(def.linearDrag) || !isRate(def.angularDamping))
        status.error = BodyError::badSettings;
    else if (!def.hull && !body.getCollisionShape())
        status.error = BodyError::noShape;
    else if (def.hull && !(def.hull->moments.volume > 0)) {
        status.error = BodyError::badHull;
        status.hull.error = HullError::noVolume;
    }
    return status;
}

FloatingBody::FloatingBody(btRigidBody& body, const BodyDef& def) : m_body(&body), m_def(def) {
    m_report.state = BodyState::notStepped;
    borrow();
    massHasChanged();
    body.activate();
}

/// Again in each step, so that what the user sets in the meantime is what he gets back.
void FloatingBody::borrow() {
    const double linear = double(m_body->getLinearDamping()), angular = double(m_body->getAngularDamping());
    if (linear != 0) m_borrowed.linearDamping = linear;
    if (angular != 0) m_borrowed.angularDamping = angular;
    if (linear != 0 || angular != 0) m_body->setDamping(0, 0);
    m_borrowed.gyroscopicFlags |= m_body->getFlags() & gyroscopicFlags;
    m_body->setFlags(m_body->getFlags() & ~gyroscopicFlags);
}

void FloatingBody::giveBack() {
    m_body->setDamping(btScalar(m_borrowed.linearDamping), btScalar(m_borrowed.angularDamping));
    m_body->setFlags((m_body->getFlags() & ~gyroscopicFlags) | m_borrowed.gyroscopicFlags);
    m_body->activate();
}

void FloatingBody::skip(BodyState reason) {
    m_report.state = reason;
    if (reason == BodyState::asleep) m_report.kineticEnergy = 0;
}

void FloatingBody::step(const WaterNow& water, double dt) {
    if (m_body->isStaticOrKinematicObject()) return skip(BodyState::notDynamic);
    if (!isFinite(*m_body)) return skip(BodyState::notFinite);
    if (staysAsleep(water)) return skip(BodyState::asleep);

    borrow();
    const Pose pose = toPose(m_body->getWorldTransform());
    const HydrostaticResult pressure = evaluateExact(hull(), pose, water.field, {water.gravity, water.time});
    const Substep substep{water, dt, pose, pressure, wetness(pressure.submergedVolume), owed(dt)};
    Motion motion;
    stepTranslation(substep, motion);
    if (turnsFreely(*m_body))
        stepRotation(substep, motion);
    else
        stepRestrictedRotation(substep, motion);
    if (substep.wet.fraction > 0) keepAwakeUnlessAtRest(water, motion);
    writeReport(substep, motion);
}

/// Still water lets sleeping bodies lie; moving water wakes those it may reach, and so does a change of mass.
bool FloatingBody::staysAsleep(const WaterNow& water) {
    const bool reweighed = massHasChanged();
    if (m_body->isActive()) return false;
    const Pose pose = toPose(m_body->getWorldTransform());
    const Vec3 centre = pose.position + pose.orientation * hull().bounds.centre;
    const double lowest = water.field.frame().pointFromWorld(centre).z() - hull().bounds.radius;
    const bool stirred = !water.bounds.still && lowest <= water.bounds.elevation;
    if (stirred || reweighed) m_body->activate();
    return !m_body->isActive();
}

/// Since it was last asked.
bool FloatingBody::massHasChanged() {
    const double inverseMass = double(m_body->getInvMass());
    const Vec3 inverseInertia = toEigen(m_body->getInvInertiaDiagLocal());
    const bool changed = inverseMass != m_knownInverseMass || inverseInertia != m_knownInverseInertia;
    m_knownInverseMass = inverseMass;
    m_knownInverseInertia = inverseInertia;
    return changed;
}

FloatingBody::Wetness FloatingBody::wetness(double submergedVolume) const {
    const double fraction = std::clamp(submergedVolume / hull().moments.volume, 0.0, 1.0);
    return {fraction, wetRate(m_def.linearDrag, fraction, m_def.scaleByWetFraction),
            wetRate(m_def.angularDamping, fraction, m_def.scaleByWetFraction)};
}

/// Gravity and water must carry a body through the same substeps. In the first one that the action sees,
/// gravity alone acted on the body; if it was woken in the middle of a stepSimulation, neither did, and for
/// the rest of that the water alone does, since Bullet applies gravity only at the start.
FloatingBody::Owed FloatingBody::owed(double dt) {
    const btVector3 weight = m_body->getGravity() * (m_body->getLinearFactor() / m_body->getInvMass());
    const bool gravityActed = m_body->getTotalForce().dot(weight) > weight.length2() / 2;
    const bool waterActed = wasStepped(m_report.state);
    m_wokenWithoutGravity = !gravityActed && (m_wokenWithoutGravity || m_report.state == BodyState::asleep);
    return {gravityActed && !waterActed ? dt : 0, waterActed && m_wokenWithoutGravity ? dt : 0};
}

/// By contacts, joints and the user in the substep that has passed.
Vec3 FloatingBody::accelerationByOthers(double dt) const {
    if (!wasStepped(m_report.state) || m_wokenWithoutGravity) return Vec3::Zero();
    return (toEigen(m_body->getLinearVelocity()) - m_handedVelocity) / dt - toEigen(m_body->getGravity());
}

/// Sets the velocity. Bullet's own damping goes on, towards rest in the world, but spares the velocity that
/// gravity is to cancel.
void FloatingBody::stepTranslation(const Substep& substep, Motion& motion) {
    const auto& [water, dt, pose, pressure, wet, owed] = substep;
    const double airRate = dampingRate(1 - m_borrowed.linearDamping, 1);
    LinearLoad load;
    load.acceleration = double(m_body->getInvMass()) * pressure.forceWorld;
    load.gravity = toEigen(m_body->getGravity());
    load.dragRate = wet.dragRate + airRate;
    if (wet.dragRate > 0 && !water.bounds.still)
        load.mediumVelocity =
            wet.dragRate / load.dragRate *
            waterVelocityAt(water.field, pose.position + pressure.centreOfBuoyancyFromCom, water.time);
    if (!wasStepped(m_report.state)) m_relief.restart();
    load.relief = m_relief.update(load.acceleration + load.gravity, accelerationByOthers(dt));

    const Vec3 before = toEigen(m_body->getLinearVelocity());
    const Vec3 arrival = before + owed.byWater * load.acceleration + owed.byGravity * load.gravity;
    const VelocityStep step = stepVelocity(arrival, load, dt);
    const Vec3 change = (step.forEngine - before).cwiseProduct(toEigen(m_body->getLinearFactor()));
    m_body->setLinearVelocity(toBullet(before + change));
    m_handedVelocity = toEigen(m_body->getLinearVelocity());

    motion.velocity = step.atPose;
    motion.kineticEnergy += translationalEnergy(1 / double(m_body->getInvMass()), step.atPose);
    motion.acceleration = unbalanced((load.acceleration + load.gravity).norm(), load.relief);
}

/// Sets the angular velocity by the momentum.
void FloatingBody::stepRotation(const Substep& substep, Motion& motion) {
    const auto& [water, dt, pose, pressure, wet, owed] = substep;
    const RotationalInertia inertia{pose.worldFromBody(),
                                    toEigen(m_body->getInvInertiaDiagLocal()).cwiseInverse()};
    const Vec3 arrival = toEigen(m_body->getAngularVelocity());
    if (wasStepped(m_report.state))
        m_momentum.absorb(inertia, arrival, dt);
    else
        m_momentum.restart(inertia, arrival, dt);
    m_momentum.addImpulse(owed.byWater * pressure.torqueAboutCom);

    const Vec3 before = m_momentum.value();
    const double relief = m_momentum.step(pressure.torqueAboutCom, wet.dampingRate, dt);
    m_body->setAngularVelocity(toBullet(inertia.spin(m_momentum.value())));
    m_momentum.handOver(inertia, toEigen(m_body->getAngularVelocity()));

    const Vec3 atPose = (before + m_momentum.value()) / 2;
    motion.kineticEnergy += rotationalEnergy(atPose, inertia.spin(atPose));
    motion.torque = unbalanced(pressure.torqueAboutCom.norm(), relief);
}

/// For a body that may not, or cannot, be turned about some axis (angular factor or inverse inertia 0):
/// others hold it there by torques that no momentum of ours knows of, so its angular velocity is its state,
/// and the torque an impulse as Bullet takes it.
void FloatingBody::stepRestrictedRotation(const Substep& substep, Motion& motion) {
    const DampedStep damped(substep.wet.dampingRate, substep.dt);
    m_body->setAngularVelocity(btScalar(damped.decay) * m_body->getAngularVelocity());
    m_body->applyTorqueImpulse(
        toBullet((substep.dt + substep.owed.byWater) * substep.pressure.torqueAboutCom));
    m_momentum = AngularMomentum();
    const Vec3 spinInBody = substep.pose.orientation.conjugate() * toEigen(m_body->getAngularVelocity());
    motion.kineticEnergy +=
        rotationalEnergy(toEigen(m_body->getLocalInertia()).cwiseProduct(spinInBody), spinInBody);
}

/// Bullet alone would let whatever is slower than 0.8 m/s fall asleep in the middle of a swing or a rise.
void FloatingBody::keepAwakeUnlessAtRest(const WaterNow& water, const Motion& motion) {
    const double length = 2 * hull().bounds.radius, inverseMass = double(m_body->getInvMass());
    const Unrest unrest{std::sqrt(2 * motion.kineticEnergy * inverseMass), motion.acceleration,
                        motion.torque * inverseMass / length};
    if (!water.bounds.still || !isAtRest(unrest, water.gravity, length)) m_body->activate();
}

void FloatingBody::writeReport(const Substep& substep, const Motion& motion) {
    const auto& [water, dt, pose, pressure, wet, owed] = substep;
    const Vec3 fromOrigin = pose.position - water.field.frame().originWorld();
    m_report.state = stateOf(wet.fraction);
    m_report.modelled = {wet.fraction > 0 && water.gravity > 0, wet.dragRate > 0, wet.dampingRate > 0,
                         turnsFreely(*m_body)};
    m_report.forceWorld = toBullet(pressure.forceWorld);
    m_report.torqueAboutCom = toBullet(pressure.torqueAboutCom);
    m_report.submergedVolume = pressure.submergedVolume;
    m_report.wetFraction = wet.fraction;
    m_report.centreOfBuoyancyWorld = toBullet(pose.position + pressure.centreOfBuoyancyFromCom);
    m_report.velocity = toBullet(motion.velocity);
    m_report.kineticEnergy = motion.kineticEnergy;
    m_report.gravitationalEnergy =
        gravitationalEnergy(1 / double(m_body->getInvMass()), toEigen(m_body->getGravity()), fromOrigin);
    m_report.waterPotentialEnergy = pressure.potentialEnergy;
}

}  // namespace bullet_buoyancy
