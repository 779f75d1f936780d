#include "bullet_buoyancy/motion/body_motion.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/motion/energy_guard.h"

namespace bullet_buoyancy {

namespace {

/// Phases, in rad a step, of the fastest oscillation that a body can have (StepperDef) up to which one look
/// at its pose is enough. A body that others touch needs a second look for the one ahead, and strays by their
/// doing anyway.
constexpr double safePhase = 0.2, safePhaseInTouch = 0.5;

/// Phases of the oscillation as it was met in the step: the leapfrog's amplitudes err by phase^2 / 8; the
/// trapezoidal rule takes over up to six steps a period, and beyond three a period there is no motion left to
/// keep.
constexpr double explicitPhase = 0.25, resolvedPhase = 1, unresolvedPhase = 2;

double smoothStep(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Square of the phase by which the load's stiffness along a flight turns an oscillation, rad^2: from the
/// change of the load over the displacement (Barzilai and Borwein's second quotient, which sees the stiff
/// part of a motion first, and nothing of one that the load does not answer to).
double phaseSquared(const Load& from, const Flight& flight, const Inertia& inertia, double dt) {
    const Vec3 force = from.force - flight.load.force, torque = from.torque - flight.load.torque;
    const Motion& departure = flight.departure;
    const double work = dt * (force.dot(departure.velocity) + torque.dot(departure.spin));
    const double admittance = force.dot(inertia.velocityChange(force)) +
                              torque.dot(inertia.spinChange(departure.pose.orientation, torque));
    return work > 0 ? dt * dt * admittance / work : 0;
}

/// Share of an explicit kick that a body held by others may be given: what would throw it, were it let go in
/// this step, no farther than its load could along its own size.
double shareWhileHeld(const Load& load, const Motion& motion, const Inertia& inertia, double size,
                      double dt) {
    const double acceleration =
        std::max(inertia.velocityChange(load.force).norm(),
                 size * inertia.spinChange(motion.pose.orientation, load.torque).norm());
    const double throwOverSize = acceleration * dt * dt / (2 * size);
    return throwOverSize > 1 ? 1 / std::sqrt(throwOverSize) : 1;
}

}  // namespace

void BodyMotion::start(const Motion& motion) {
    *this = BodyMotion();
    m_motion = motion;
}

void BodyMotion::arriveElsewhere(const Inertia& inertia, const Pose& pose, const Disturbance& disturbance) {
    const Motion& departure = m_flight.departure;
    m_disturbed = true;
    m_impulse = inertia.mass * disturbance.velocityChange;
    m_angularImpulse = inertia.momentum(departure.pose.orientation, disturbance.spinChange);
    m_motion = departure;
    m_motion.velocity += disturbance.velocityChange;
    if (disturbance.turnedByHand) m_motion.pose = pose;
    m_motion.setSpin(inertia, departure.spin + disturbance.spinChange);
    m_motion.moveTo(inertia, pose);
}

void BodyMotion::arriveAstray(const Inertia& inertia, const Pose& pose) {
    arriveElsewhere(inertia, pose, {});
    m_disturbed = m_knowsLoadAhead = false;
}

void BodyMotion::settle(const Inertia& inertia, const StepperDef& def, const LoadField& field, double dt) {
    m_evaluations = 0;
    if (m_knowsLoadAhead && !m_disturbed)
        m_load = m_flight.load;
    else
        evaluate(field);
    noteOthers(inertia, dt);

    m_kick = Kick(m_load, dt);
    if (!m_isNew) endStep(inertia);
    account(inertia);
    if (def.stepping == Stepping::guarded) limitEnergy(m_motion, inertia, m_load, m_available);
    m_energy = totalEnergy(m_motion, inertia, m_load);
}

void BodyMotion::spend(const Dissipation& dissipated) {
    m_ledger.toDrag += dissipated.byDrag;
    m_ledger.toDamping += dissipated.byDamping;
    m_energy -= dissipated.sum();
    m_available -= dissipated.sum();
}

/// The second half of the load of a step.
void BodyMotion::endStep(const Inertia& inertia) {
    spend(m_kick.apply(m_motion, inertia, m_carriedForce + m_weightOfArrival * m_load.force,
                       m_carriedTorque + m_weightOfArrival * m_load.torque));
}

void BodyMotion::evaluate(const LoadField& field) {
    m_load = field.at(m_motion.pose);
    ++m_evaluations;
}

/// A load that they carry in two steps running they will carry in the next.
void BodyMotion::noteOthers(const Inertia& inertia, double dt) {
    m_linearRelief.update(inertia.velocityChange(m_load.force), inertia.velocityChange(m_impulse) / dt);
    m_angularRelief.update(m_load.torque, m_angularImpulse / dt);
    m_impulse.setZero();
    m_angularImpulse.setZero();
}

/// What may be there from now on, and by whom it came.
void BodyMotion::account(const Inertia& inertia) {
    const double now = totalEnergy(m_motion, inertia, m_load);
    if (m_isNew) {
        m_available = now;
        m_ledger = {now, 0, 0, 0};
    } else if (m_disturbed) {
        m_ledger.byOthers += now - m_energy;
        m_available = now;
    } else if (m_damps) {
        m_available = std::min(m_available, now);
    }
    m_isNew = m_damps = false;
}

/// Others carry what is on it, and it stays where they hold it.
bool BodyMotion::isHeld() const {
    return linearRelief() > 0.5 || angularRelief() > 0.5;
}

bool BodyMotion::mustLookAhead(const StepperDef& def, double dt) const {
    if (def.stepping == Stepping::published || isHeld()) return false;
    const double phase = m_disturbed ? safePhaseInTouch : safePhase;
    return def.stiffestRate2 * dt * dt > phase * phase;
}

void BodyMotion::depart(const Inertia& inertia, const StepperDef& def, const LoadField& field, double dt) {
    m_knowsLoadAhead = mustLookAhead(def, dt);
    m_carriedForce.setZero();
    m_carriedTorque.setZero();
    m_weightOfArrival = 1;
    m_flight = flyExplicitly(inertia, def, dt);
    if (m_knowsLoadAhead) m_flight = flyWithCare(m_flight, inertia, field, dt);
    spend(m_flight.dissipated);
    m_disturbed = false;
}

Flight BodyMotion::flyExplicitly(const Inertia& inertia, const StepperDef& def, double dt) const {
    Kick kick = m_kick;
    kick.extraForce = linearRelief() * kick.linear.lostInTwoSteps();
    kick.extraTorque = angularRelief() * kick.angular.lostInTwoSteps();
    const double share = isHeld() ? shareWhileHeld(m_load, m_motion, inertia, def.size, dt) : 1;
    Flight flight;
    flight.departure = m_motion;
    flight.dissipated = kick.apply(flight.departure, inertia, share * m_load.force, share * m_load.torque);
    flight.arrival = fly(flight.departure, inertia, dt, turningOf(inertia, def.stepping));
    return flight;
}

/// Looks at where the explicit flight would end. What it strays by there is no more than a share of the
/// energy that is in motion now, or else it is not taken.
Flight BodyMotion::flyWithCare(Flight explicitFlight, const Inertia& inertia, const LoadField& field,
                               double dt) {
    explicitFlight.load = field.at(explicitFlight.arrival.pose);
    ++m_evaluations;
    const double phase = std::sqrt(phaseSquared(m_load, explicitFlight, inertia, dt));
    if (phase <= explicitPhase && isWithinEnergy(explicitFlight, inertia)) return explicitFlight;

    const double implicitness = smoothStep((phase - resolvedPhase) / (unresolvedPhase - resolvedPhase));
    Flight flight = flyImplicitly(inertia, field, implicitness, dt);
    if (implicitness < 1 && !isWithinEnergy(flight, inertia)) flight = flyImplicitly(inertia, field, 1, dt);
    return flight;
}

bool BodyMotion::isWithinEnergy(const Flight& flight, const Inertia& inertia) const {
    constexpr double allowance = 0.1;  // of the motion's energy: at its turning points phase^2 / 8 and less
    return flight.load.potential <= m_available + allowance * kineticEnergy(m_motion, inertia);
}

Flight BodyMotion::flyImplicitly(const Inertia& inertia, const LoadField& field, double implicitness,
                                 double dt) {
    FlightStart start{m_motion, m_load, Mat6::Zero()};
    field.at(m_motion.pose, &start.stiffness);
    const Flight flight = bullet_buoyancy::flyImplicitly(start, inertia, implicitness, dt, field);
    m_evaluations += 1 + flight.evaluations;
    const KickWeights weights(implicitness);
    m_carriedForce = weights.lastOfStart * m_load.force;
    m_carriedTorque = weights.lastOfStart * m_load.torque;
    m_weightOfArrival = weights.lastOfEnd;
    m_damps = implicitness > 0;
    return flight;
}

}  // namespace bullet_buoyancy
