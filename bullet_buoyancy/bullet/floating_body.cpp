#include "bullet_buoyancy/bullet/floating_body.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/core/fill_rows.h"
#include "bullet_buoyancy/hydrostatics/stiffness_bound.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"
#include "bullet_buoyancy/motion/energy.h"
#include "bullet_buoyancy/motion/rest.h"

namespace bullet_buoyancy {

namespace {

bool isFinite(const btRigidBody& body) {
    const btTransform& transform = body.getWorldTransform();
    Vec3 sum = toEigen(transform.getOrigin()) + toEigen(body.getLinearVelocity()) +
               toEigen(body.getAngularVelocity()) + toEigen(body.getInvInertiaDiagLocal()) +
               Vec3::Constant(double(body.getInvMass()));
    for (int row = 0; row < 3; ++row)
        sum += toEigen(transform.getBasis()[row]);
    return sum.allFinite();  // NaN and infinity survive every sum
}

bool isFinite(const Motion& motion) {
    return (motion.velocity + motion.spin).allFinite();
}

/// About every axis of its own.
bool hasInertia(const btRigidBody& body) {
    return toEigen(body.getInvInertiaDiagLocal()).minCoeff() > 0;
}

bool turnsFreely(const btRigidBody& body) {
    return hasInertia(body) && toEigen(body.getAngularFactor()) == Vec3::Ones();
}

Inertia inertiaOf(const btRigidBody& body) {
    Inertia inertia;
    inertia.mass = 1 / double(body.getInvMass());
    inertia.inversePrincipal = toEigen(body.getInvInertiaDiagLocal());
    for (int i = 0; i < 3; ++i)
        inertia.principal[i] = inertia.inversePrincipal[i] > 0 ? 1 / inertia.inversePrincipal[i] : 0;
    inertia.linearFactor = toEigen(body.getLinearFactor());
    inertia.angularFactor = toEigen(body.getAngularFactor());
    inertia.turnsFreely = turnsFreely(body);
    return inertia;
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

BodyStatus FloatingBody::checkHull(const btRigidBody& body, const Hull* hull) {
    BodyStatus status;
    status.canTurn = hasInertia(body);
    if (!hull && !body.getCollisionShape()) {
        status.error = BodyError::noShape;
    } else if (hull && !(hull->moments.volume > 0)) {
        status.error = BodyError::badHull;
        status.hull.error = HullError::noVolume;
    }
    return status;
}

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
    else
        return checkHull(body, def.hull.get());
    return status;
}

FloatingBody::FloatingBody(btRigidBody& body, const BodyDef& def) : m_body(&body), m_def(def) {
    lookAtHull();
    m_borrowed.borrow(body);
    m_lastSeenVelocity = toEigen(body.getLinearVelocity());
    massHasChanged();
    body.activate();
}

void FloatingBody::giveBack() {
    m_borrowed.giveBack(*m_body);
    m_body->activate();
}

void FloatingBody::changeHull(std::shared_ptr<const Hull> hull) {
    m_def.hull = std::move(hull);
    lookAtHull();
    m_isPlain = isPlain();
    findFlexibility();
    m_motion.meetOtherLoad();
    m_body->activate();
}

/// Notes what follows from it, and whose it is.
void FloatingBody::lookAtHull() {
    m_size = hull().bounds.centre.norm() + hull().bounds.radius;
    m_knownShape = m_body->getCollisionShape();
    m_knownScaling = m_knownShape ? m_knownShape->getLocalScaling() : btVector3(1, 1, 1);
}

void FloatingBody::skip(BodyState reason) {
    m_state = reason;
    m_lastSeenVelocity = toEigen(m_body->getLinearVelocity());
}

void FloatingBody::step(const WaterNow& water, double dt) {
    if (m_body->isStaticOrKinematicObject()) return skip(BodyState::notDynamic);
    if (!isFinite(*m_body)) return skip(BodyState::notFinite);
    const bool reweighed = massHasChanged();
    if (staysAsleep(water, reweighed)) return skip(BodyState::asleep);

    m_borrowed.borrow(*m_body);
    m_waterSamples = 0;
    m_gravity = toEigen(m_body->getGravity());
    m_isPressed = water.gravity > 0;
    const WaterLoad now(water, m_def, m_inertia.mass, m_gravity, m_borrowed.linearDampingRate(),
                        m_waterSamples);
    StepperDef stepper = stepperDef(water);
    arrive(stepper, now, reweighed, dt);
    m_motion.settle(m_inertia, stepper, now, dt);
    stepper.turnLimit -= std::min(largestTurn, m_handover.lag(m_motion.motion().pose));
    m_motion.depart(m_inertia, stepper, now.after(dt), dt);
    m_hasMotion = isFinite(m_motion.departure());
    if (!m_hasMotion) return skip(BodyState::notFinite);
    m_handover.give(*m_body, m_motion, turningOf(m_inertia, m_def.scheme), dt);
    m_state = stateOf(wetFraction(m_motion.load(), hull()));
    if (m_state != BodyState::dry || isStirred(water)) keepAwakeUnlessAtRest(water);
}

bool FloatingBody::isAtEase(const WaterNow& water, double dt) const {
    return m_isPlain && wasStepped(m_state) && !m_wokenWithoutGravity &&
           m_motion.isAtEase(stepperDef(water), dt) && m_body->isActive() &&
           !m_body->isStaticOrKinematicObject() && m_borrowed.isAll(*m_body) && isInertiaKnown() &&
           toEigen(m_body->getGravity()) == m_gravity && m_handover.isAsGiven(*m_body, dt);
}

void FloatingBody::put(CalmRows& rows, int lane) const {
    m_motion.put(m_inertia, rows.arrivals, lane);
    rows.arrivals.length.lane[lane] = length();
    m_handover.put(*m_body, rows.returns, lane);
    bullet_buoyancy::put(m_inertia.mass * m_gravity, rows.floating.weight, lane);
    rows.floating.linearDrag.lane[lane] = m_def.linearDrag;
    rows.floating.angularDamping.lane[lane] = m_def.angularDamping;
    rows.floating.scales.lane[lane] = m_def.scaleByWetFraction;
    rows.floating.airRate.lane[lane] = m_borrowed.linearDampingRate();
    rows.displacement.setHull(lane, hull());
}

void FloatingBody::stepCalmly(const CalmRows& rows, int lane, const WaterNow& water, double dt) {
    m_waterSamples = 0;
    m_isPressed = water.gravity > 0;
    m_handover.prepare(*m_body, m_motion.target(), rows.gifts, lane, dt);
    m_motion.stepCalmly(rows.steps, rows.loads, lane);
    m_handover.giveAsPrepared(*m_body);
    m_state = stateOf(wetFraction(m_motion.load(), hull()));
    if (m_state != BodyState::dry && !(rows.steps.isAtRest.lane[lane] > 0)) m_body->activate();
}

/// Still water lets sleeping bodies lie; moving water wakes those it may reach, and so does a change of mass.
bool FloatingBody::staysAsleep(const WaterNow& water, bool reweighed) {
    if (m_body->isActive()) return false;
    if (reweighed || isStirred(water)) m_body->activate();
    return !m_body->isActive();
}

/// Moving water may reach the body, sooner or later.
bool FloatingBody::isStirred(const WaterNow& water) const {
    if (water.bounds.still) return false;
    const Pose pose = toPose(m_body->getWorldTransform());
    const Vec3 centre = pose.position + pose.orientation * hull().bounds.centre;
    const double lowest = water.field.frame().pointFromWorld(centre).z() - hull().bounds.radius;
    return lowest <= water.bounds.elevation;
}

bool FloatingBody::isInertiaKnown() const {
    return double(m_body->getInvMass()) == m_inverseMass &&
           toEigen(m_body->getInvInertiaDiagLocal()) == m_inertia.inversePrincipal &&
           toEigen(m_body->getLinearFactor()) == m_inertia.linearFactor &&
           toEigen(m_body->getAngularFactor()) == m_inertia.angularFactor;
}

/// Since it was last asked; notes what follows from it. Factors may change without a change of mass.
bool FloatingBody::massHasChanged() {
    if (isInertiaKnown()) return false;
    const Inertia now = inertiaOf(*m_body);
    const double inverseMass = double(m_body->getInvMass());
    const bool changed = inverseMass != m_inverseMass || now.inversePrincipal != m_inertia.inversePrincipal ||
                         now.turnsFreely != m_inertia.turnsFreely;
    m_inverseMass = inverseMass;
    m_inertia = now;
    m_isPlain = isPlain();
    if (changed) findFlexibility();
    return changed;
}

/// By the settings, the hull and the inertia.
bool FloatingBody::isPlain() const {
    return m_def.scheme == StepScheme::guarded && isDisplacementAlone(hull(), {}) && m_inertia.turnsFreely &&
           m_inertia.linearFactor == Vec3::Ones();
}

/// From the hull and the inertia.
void FloatingBody::findFlexibility() {
    const StiffnessBound bound = stiffnessBound(hull(), 1);
    m_flexibility = std::max(bound.heave / m_inertia.mass,
                             bound.perAxisTurn.cwiseProduct(m_inertia.inversePrincipal).maxCoeff());
}

bool FloatingBody::shapeHasChanged() const {
    const btCollisionShape* shape = m_body->getCollisionShape();
    return shape != m_knownShape || (shape && !(shape->getLocalScaling() == m_knownScaling));
}

/// On the body, in the substep that has passed.
bool FloatingBody::gravityActed() const {
    const btVector3 gravity = m_body->getGravity() * m_body->getLinearFactor();
    return gravity.isZero() ||
           m_body->getTotalForce().dot(gravity) * m_body->getInvMass() > gravity.length2() / 2;
}

/// After a body has been woken in the middle of a stepSimulation, Bullet leaves gravity out for the rest of
/// it.
void FloatingBody::arrive(const StepperDef& stepper, const WaterLoad& now, bool reweighed, double dt) {
    const bool gravity = gravityActed();
    m_wokenWithoutGravity = !gravity && (m_wokenWithoutGravity || m_state == BodyState::asleep);
    const Return how = m_handover.take(*m_body, m_motion.target(), dt, !m_wokenWithoutGravity);
    if (!wasStepped(m_state)) {
        start(stepper, now, gravity, dt);
    } else if (reweighed) {
        Disturbance atItsSpin = m_handover.disturbance();
        atItsSpin.turnedByHand = true;
        m_motion.arriveElsewhere(m_inertia, m_handover.pose(), atItsSpin);
    } else if (how == Return::atTarget) {
        m_motion.arrive();
    } else if (how == Return::astray) {
        if (dt != m_handover.dt()) m_motion.departAgain(m_inertia, stepper, now, dt);
        m_motion.arrive();  // and Bullet's body is led there
    } else {
        m_motion.arriveElsewhere(m_inertia, m_handover.pose(), m_handover.disturbance());
    }
}

/// Bullet takes a body's first step before the action sees it, with gravity and without water. Where nothing
/// held the body, that step is taken again, by us; Bullet's body is led to its end in the next one, up or
/// down. Against the way that it fell it is not led far: something may lie there.
void FloatingBody::start(const StepperDef& stepper, const WaterLoad& now, bool gravity, double dt) {
    Motion before = motionBefore(dt);
    if (!gravity || wasHeld(dt)) {
        before.moveTo(m_inertia, m_handover.pose());
        return m_motion.start(before);
    }
    before.velocity -= dt * m_inertia.velocityChange(now.weight());
    StepperDef cautious = stepper;
    cautious.turnLimit = largestTurn / 2;  // so that Bullet's body can be led there
    m_motion.start(before);
    m_motion.settle(m_inertia, cautious, now.after(-dt), dt);
    m_motion.depart(m_inertia, cautious, now, dt);

    const Vec3 up = now.up(), start = before.pose.position, target = m_motion.target().position;
    const Vec3 bullets = m_handover.pose().position;
    const double fallen = up.dot(bullets - start), moved = up.dot(target - start);
    constexpr double shortWay = 0.1;  // of the body's size
    if (moved * fallen < 0 && std::abs(moved) > shortWay * stepper.size) return m_motion.start(before);
    m_motion.arriveBeside(bullets + up.dot(target - bullets) * up - target);
}

/// In Bullet's first step: it does not move as it did when last seen and gravity has it, nor fast enough that
/// nothing can have held it against gravity.
bool FloatingBody::wasHeld(double dt) const {
    const Vec3 velocity = toEigen(m_body->getLinearVelocity()), gravity = toEigen(m_body->getGravity());
    const Vec3 falling = m_lastSeenVelocity + dt * gravity.cwiseProduct(toEigen(m_body->getLinearFactor()));
    const double fall = dt * gravity.norm();
    constexpr double rounding = 1e-5;  // of Bullet's single precision, in full in the one and the other
    if ((velocity - falling).norm() <= rounding * (fall + velocity.norm())) return false;
    return std::abs(velocity.dot(gravity)) * dt < fall * fall / 2;
}

/// Bullet moved the body at the velocities it has now.
Motion FloatingBody::motionBefore(double dt) const {
    Motion motion;
    motion.pose = m_handover.pose();
    motion.velocity = toEigen(m_body->getLinearVelocity());
    motion.spin = toEigen(m_body->getAngularVelocity());
    motion.pose = fly(motion, m_inertia, -dt, Turning::atSpin).pose;
    motion.setSpin(m_inertia, motion.spin);
    return motion;
}

/// Bullet alone would let whatever is slower than 0.8 m/s fall asleep in the middle of a swing or a rise.
void FloatingBody::keepAwakeUnlessAtRest(const WaterNow& water) {
    if (!water.bounds.still || !isAtRest(water.gravity)) m_body->activate();
}

bool FloatingBody::isAtRest(double gravity) const {
    const Load& load = m_motion.load();
    const double speed = std::sqrt(2 * kineticEnergy(m_motion.motion(), m_inertia) * m_inverseMass);
    const double angular = m_inertia.turnsFreely ? load.torque.norm() * m_inverseMass / length() : 0;
    const Unrest unrest{speed,
                        unbalanced(m_inertia.velocityChange(load.force).norm(), m_motion.linearRelief()),
                        unbalanced(angular, m_motion.angularRelief())};
    return bullet_buoyancy::isAtRest(unrest, gravity, length());
}

BodyReport FloatingBody::report(const WaterFrame& frame) const {
    BodyReport report;
    report.state = m_state;
    if (!m_hasMotion) return report;
    const Motion& motion = m_motion.motion();
    const Load& load = m_motion.load();
    report.wetFraction = wetFraction(load, hull());
    report.modelled = {report.wetFraction > 0 && m_isPressed, load.dragRate > 0, load.dampingRate > 0,
                       m_inertia.turnsFreely};
    report.forceWorld = toBullet(load.force - m_inertia.mass * m_gravity);
    report.forceErrorBound = load.forceErrorBound;
    report.torqueAboutCom = toBullet(load.torque);
    report.submergedVolume = load.displacement;
    report.centreOfBuoyancyWorld = toBullet(motion.pose.position + load.centreFromCom);
    report.velocity = toBullet(motion.velocity);
    report.spin = toBullet(motion.spin);
    report.angularMomentum = toBullet(motion.momentum);
    report.kineticEnergy = m_state == BodyState::asleep ? 0 : kineticEnergy(motion, m_inertia);
    report.gravitationalEnergy =
        gravitationalEnergy(m_inertia.mass, m_gravity, motion.pose.position - frame.originWorld());
    report.waterPotentialEnergy = load.potential - report.gravitationalEnergy;
    report.energy = m_motion.ledger();
    if (wasStepped(m_state)) {
        report.evaluations = m_motion.evaluations();
        report.waterSamples = m_waterSamples;
    }
    report.spinIsLimited = m_motion.departure().spin.norm() * m_handover.dt() > largestTurn;
    report.shapeHasChanged = shapeHasChanged();
    return report;
}

}  // namespace bullet_buoyancy
