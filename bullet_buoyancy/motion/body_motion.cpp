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
/// A body in touch gets its whole load as long as that is safe, to press with.
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

void BodyMotion::arriveBeside(const Vec3& offset) {
    m_motion = m_flight.arrival;
    m_motion.pose.position += offset;
    m_knowsLoadAhead = false;
}

void BodyMotion::arriveElsewhere(const Inertia& inertia, const Pose& pose, const Disturbance& disturbance) {
    const Motion& departure = m_flight.departure;
    m_disturbed = true;
    m_velocityChange = disturbance.velocityChange;
    m_angularImpulse = inertia.momentum(departure.pose.orientation, disturbance.spinChange);
    m_motion = departure;
    m_motion.velocity += disturbance.velocityChange;
    if (disturbance.turnedByHand) m_motion.pose = pose;
    m_motion.setSpin(inertia, departure.spin + disturbance.spinChange);
    m_motion.moveTo(inertia, pose);
}

void BodyMotion::settle(const Inertia& inertia, const StepperDef& def, const LoadField& field, double dt) {
    m_evaluations = 0;
    if (m_knowsLoadAhead && !m_disturbed)
        m_load = m_flight.load;
    else
        evaluate(field);
    noteOthers();

    m_kick = Kick(m_load, dt);
    const bool owed = isHeld();  // others will take it: the body has it only when it leaves
    if (!m_isNew && !owed) m_dissipated += endStep(m_motion, inertia, 1);
    account(inertia);
    if (def.scheme == StepScheme::guarded)
        limitEnergy(m_motion, inertia, m_load, {m_available, field.up(), m_isUnresolved});
    m_energy = totalEnergy(m_motion, inertia, m_load);

    m_leaving = m_motion;
    if (owed) endStep(m_leaving, inertia, shareWhileHeld(m_load, m_motion, inertia, def.size, dt));
}

/// The second half of the load of a step, or a share of it.
Dissipation BodyMotion::endStep(Motion& motion, const Inertia& inertia, double share) const {
    return m_kick.apply(motion, inertia, share * (m_carriedForce + m_weightOfArrival * m_load.force),
                        share * (m_carriedTorque + m_weightOfArrival * m_load.torque));
}

/// What the medium took. Of a step that is not resolved its estimate may be far more than the body has lost.
void BodyMotion::spend(double now) {
    const double estimate = m_dissipated.sum(), lost = std::max(0.0, m_energy - now);
    const double share = m_isUnresolved && estimate > lost ? lost / estimate : 1;
    m_ledger.toDrag += share * m_dissipated.byDrag;
    m_ledger.toDamping += share * m_dissipated.byDamping;
    m_energy -= share * estimate;
    m_available -= share * estimate;
}

void BodyMotion::evaluate(const LoadField& field) {
    m_load = field.at(m_motion.pose);
    ++m_evaluations;
}

/// What they take of the body's load in two steps running they will take in the next.
void BodyMotion::noteOthers() {
    if (!m_isNew) {
        m_linearRelief.update(m_flight.departure.velocity - m_arrivalVelocity, m_velocityChange);
        m_angularRelief.update(m_flight.departure.momentum - m_arrivalMomentum, m_angularImpulse);
    }
    m_arrivalVelocity = m_motion.velocity;
    m_arrivalMomentum = m_motion.momentum;
    m_velocityChange.setZero();
    m_angularImpulse.setZero();
}

/// What may be there from now on, and by whom it came.
void BodyMotion::account(const Inertia& inertia) {
    const double now = totalEnergy(m_motion, inertia, m_load);
    spend(now);
    if (m_isNew) {
        m_available = now;
        m_ledger = {now, 0, 0, 0};
    } else if (m_disturbed) {
        m_ledger.byOthers += now - m_energy;
        m_available = now;
    } else if (m_damps) {
        m_available = std::min(m_available, now);
    }
    if (m_isNew) m_disturbed = false;
    m_isNew = m_damps = false;
}

/// Others carry what is on it, and it stays where they hold it.
bool BodyMotion::isHeld() const {
    return linearRelief() > 0.5 || angularRelief() > 0.5;
}

bool BodyMotion::mustLookAhead(const StepperDef& def, double dt) const {
    if (def.scheme == StepScheme::published || isHeld()) return false;
    const double phase = m_disturbed ? safePhaseInTouch : safePhase;
    return def.stiffestRate2 * dt * dt > phase * phase;
}

void BodyMotion::depart(const Inertia& inertia, const StepperDef& def, const LoadField& field, double dt) {
    m_knowsLoadAhead = mustLookAhead(def, dt);
    m_carriedForce.setZero();
    m_carriedTorque.setZero();
    m_weightOfArrival = 1;
    m_flight = flyExplicitly(inertia, def, dt);
    m_isUnresolved = m_flight.departure.spin.norm() * dt > def.turnLimit;
    if (m_knowsLoadAhead) m_flight = flyWithCare(m_flight, inertia, def, field, dt);
    m_dissipated = m_flight.dissipated;
    m_disturbed = false;
}

void BodyMotion::departAgain(const Inertia& inertia, const StepperDef& def, const LoadField& field,
                             double dt) {
    m_kick = Kick(m_load, dt);
    m_damps = false;
    depart(inertia, def, field, dt);
}

Flight BodyMotion::flyExplicitly(const Inertia& inertia, const StepperDef& def, double dt) const {
    Kick kick = m_kick;
    kick.extraForce = linearRelief() * kick.linear.lostInTwoSteps();
    kick.extraTorque = angularRelief() * kick.angular.lostInTwoSteps();
    const double share = isHeld() ? shareWhileHeld(m_load, m_motion, inertia, def.size, dt) : 1;
    Flight flight;
    flight.departure = m_leaving;
    flight.dissipated = kick.apply(flight.departure, inertia, share * m_load.force, share * m_load.torque);
    flight.arrival = fly(flight.departure, inertia, dt, turningOf(inertia, def.scheme), def.turnLimit);
    return flight;
}

/// Looks at where the explicit flight would end. A leapfrog strays in its turning points by phase^4 / 8 of
/// the energy of an oscillation, whose motion has come down to phase^2 / 4 of it by then. A flight that ends
/// where energy forbids is not taken.
Flight BodyMotion::flyWithCare(Flight explicitFlight, const Inertia& inertia, const StepperDef& def,
                               const LoadField& field, double dt) {
    explicitFlight.load = field.at(explicitFlight.arrival.pose);
    ++m_evaluations;
    const double phase2 = phaseSquared(m_load, explicitFlight, inertia, dt), phase = std::sqrt(phase2);
    const auto isAllowed = [&](const Flight& flight, double strayed) {
        return isWithinEnergy(flight, inertia, field.up(), strayed);
    };
    const double stillExplicit = m_disturbed ? resolvedPhase : explicitPhase;
    if (phase <= stillExplicit && isAllowed(explicitFlight, phase2 / 2)) return explicitFlight;

    m_isUnresolved = true;
    FlightStart start{m_leaving, m_load, Mat6::Zero(), def.turnLimit};
    field.at(m_motion.pose, &start.stiffness);
    ++m_evaluations;
    constexpr double converged = 1e-3;  // what Newton's method leaves
    const double implicitness = smoothStep((phase - resolvedPhase) / (unresolvedPhase - resolvedPhase));
    Flight flight = flyImplicitly(start, inertia, field, implicitness, dt);
    if (implicitness < 1 && !isAllowed(flight, converged))
        flight = flyImplicitly(start, inertia, field, 1, dt);
    if (m_damps && !isAllowed(flight, 0)) flight = slideAlong(inertia, field, dt);
    return flight;
}

/// Across `up`, without turning: the load stays as it is.
Flight BodyMotion::slideAlong(const Inertia& inertia, const LoadField& field, double dt) {
    Flight flight;
    flight.departure = m_leaving;
    flight.departure.velocity -= field.up().dot(m_leaving.velocity) * field.up();
    flight.departure.setSpin(inertia, Vec3::Zero());
    flight.arrival = fly(flight.departure, inertia, dt, Turning::atSpin);
    flight.load = field.at(flight.arrival.pose);
    ++m_evaluations;
    return flight;
}

/// At its end, to `strayed` of the energy with which the body moves against the load; or at least not farther
/// without than it began.
bool BodyMotion::isWithinEnergy(const Flight& flight, const Inertia& inertia, const Vec3& up,
                                double strayed) const {
    const double moving = kineticEnergy(m_leaving, inertia) - keptEnergy(m_leaving, inertia, up);
    const double limit = m_available - keptEnergy(flight.arrival, inertia, up) + strayed * moving;
    return flight.load.potential <= std::max(limit, m_load.potential);
}

Flight BodyMotion::flyImplicitly(const FlightStart& start, const Inertia& inertia, const LoadField& field,
                                 double implicitness, double dt) {
    const Flight flight = bullet_buoyancy::flyImplicitly(start, inertia, implicitness, dt, field);
    m_evaluations += flight.evaluations;
    const KickWeights weights(implicitness);
    m_carriedForce = weights.lastOfStart * m_load.force;
    m_carriedTorque = weights.lastOfStart * m_load.torque;
    m_weightOfArrival = weights.lastOfEnd;
    m_damps = implicitness > 0;
    return flight;
}

}  // namespace bullet_buoyancy
