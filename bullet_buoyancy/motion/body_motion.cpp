#include "bullet_buoyancy/motion/body_motion.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/fill_rows.h"
#include "bullet_buoyancy/motion/energy_guard.h"
#include "bullet_buoyancy/motion/free_rotation.h"

namespace bullet_buoyancy {

namespace {

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

/// How far a load would throw a body in a step, over its size.
double throwOverSize(const Vec3& force, const Vec3& torque, const Eigen::Quaterniond& orientation,
                     const Inertia& inertia, double size, double dt) {
    const double acceleration =
        std::max(inertia.velocityChange(force).norm(), size * inertia.spinChange(orientation, torque).norm());
    return acceleration * dt * dt / (2 * size);
}

/// Square of the phase by which the field's movement in a step may excite a body at rest: by the stiffness
/// along the change of the load, or, where the body has lost it by coming out or going under, by its size.
double phaseSquaredOfField(const Load& before, const Load& after, const Mat6& stiffness,
                           const Eigen::Quaterniond& orientation, const Inertia& inertia, double size,
                           double dt) {
    const Vec3 force = after.force - before.force, torque = after.torque - before.torque;
    Vec6 change, answer;
    change << force, torque;
    answer << inertia.velocityChange(force), inertia.spinChange(orientation, torque);
    const double admittance = change.dot(answer), ofStiffness = dt * dt * answer.dot(stiffness * answer);
    return std::max(admittance > 0 ? ofStiffness / admittance : 0,
                    2 * throwOverSize(force, torque, orientation, inertia, size, dt));
}

/// Share of an explicit kick that a body held by others may be given: what would throw it, were it let go in
/// this step, no farther than its load could along its own size.
double shareWhileHeld(const Load& load, const Motion& motion, const Inertia& inertia, double size,
                      double dt) {
    const double far = throwOverSize(load.force, load.torque, motion.pose.orientation, inertia, size, dt);
    return far > 1 ? 1 / std::sqrt(far) : 1;
}

/// In calm water nothing moves.
void get(const LoadRows& rows, int lane, Load& load) {
    get(rows.force, lane, load.force);
    get(rows.torque, lane, load.torque);
    load.potential = rows.potential.lane[lane];
    load.potentialRounding = rows.potentialRounding.lane[lane];
    load.dragRate = rows.dragRate.lane[lane];
    load.dampingRate = rows.dampingRate.lane[lane];
    load.mediumVelocity.setZero();
    load.displacement = rows.displacement.lane[lane];
    get(rows.centreFromCom, lane, load.centreFromCom);
    load.forceErrorBound = rows.forceErrorBound.lane[lane];
}

void get(const MovingRows& rows, int lane, Motion& motion) {
    get(rows.velocity, lane, motion.velocity);
    get(rows.momentum, lane, motion.momentum);
    get(rows.spin, lane, motion.spin);
}

void get(const DissipationRows& rows, int lane, Dissipation& dissipated) {
    dissipated.byDrag = rows.byDrag.lane[lane];
    dissipated.byDamping = rows.byDamping.lane[lane];
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

void BodyMotion::settle(const Inertia& inertia, const StepperDef& def, const LoadField& now, double dt) {
    m_evaluations = 0;
    const bool calm = m_isCalm && now.isCalm();
    const bool foreseen = m_knowsLoadAhead && !m_disturbed && m_isCalm == now.isCalm();
    if (foreseen)
        m_load = m_flight.load;
    else
        evaluate(now);
    noteOthers();

    prepareKick(inertia, dt);
    m_isOwed = isHeld();  // the body has it only when it leaves
    if (!m_isNew && !m_isOwed) m_dissipated += endStep(m_motion, inertia, 1);
    m_energy = account(inertia, calm, foreseen);
    if (def.scheme == StepScheme::guarded && m_energy > m_available + m_load.potentialRounding) {
        limitEnergy(m_motion, inertia, m_load, {m_available, now.up(), m_isUnresolved});
        m_energy = totalEnergy(m_motion, inertia, m_load);
    }
    m_settledVelocity = m_motion.velocity;
    m_settledSpin = m_motion.spin;

    if (!m_isOwed) return;
    m_leaving = m_motion;
    endStep(m_leaving, inertia, shareWhileHeld(m_load, m_motion, inertia, def.size, dt));
}

void BodyMotion::prepareKick(const Inertia& inertia, double dt) {
    m_kick = Kick(m_load, dt);
    m_push = Push(inertia, m_motion.pose.orientation, m_load.force, m_load.torque);
}

/// The second half of the load of a step, or a share of it.
Dissipation BodyMotion::endStep(Motion& motion, const Inertia& inertia, double share) const {
    const bool byArrivalAlone = m_weightOfArrival == 1;
    if (byArrivalAlone) return m_kick.apply(motion, inertia, share == 1 ? m_push : share * m_push);
    return m_kick.apply(motion, inertia, share * (m_carriedForce + m_weightOfArrival * m_load.force),
                        share * (m_carriedTorque + m_weightOfArrival * m_load.torque));
}

/// What the medium took. Of a step that is not resolved its estimate may be far more than the body has lost.
void BodyMotion::spend(double now) {
    const double estimate = m_dissipated.sum(), lost = std::max(0.0, m_energy + m_workOfField - now);
    const double share = m_isUnresolved && estimate > lost ? lost / estimate : 1;
    m_ledger.toDrag += share * m_dissipated.byDrag;
    m_ledger.toDamping += share * m_dissipated.byDamping;
    m_energy -= share * estimate;
    m_available -= share * estimate;
}

void BodyMotion::evaluate(const LoadField& now) {
    m_load = now.at(m_motion.pose);
    ++m_evaluations;
}

/// What they take of the body's load in two steps running they will take in the next.
void BodyMotion::noteOthers() {
    if (!m_disturbed) {
        m_linearRelief.updateUntouched();
        m_angularRelief.updateUntouched();
    } else if (!m_isNew) {
        m_linearRelief.update(m_flight.departure.velocity - m_arrivalVelocity, m_velocityChange);
        m_angularRelief.update(m_flight.departure.momentum - m_arrivalMomentum, m_angularImpulse);
    }
    m_arrivalVelocity = m_motion.velocity;
    m_arrivalMomentum = m_motion.momentum;
}

/// What is there now, J; notes what may be there from now on, and by whom it came.
double BodyMotion::account(const Inertia& inertia, bool calm, bool foreseen) {
    const double now = totalEnergy(m_motion, inertia, m_load);
    spend(now);
    if (m_isNew) {
        m_available = now;
        m_ledger = EnergyLedger();
        m_ledger.start = now;
    } else if (!calm) {
        const double byOthers = workOfOthers(inertia);
        m_ledger.byOthers += byOthers;
        m_ledger.byWater += now - m_energy - byOthers;
        if (!foreseen || !(m_isUnresolved || m_damps)) m_available = now;
    } else if (m_disturbed) {
        m_ledger.byOthers += now - m_energy;
        m_available = now;
    } else if (m_damps) {
        m_available = std::min(m_available, now);
    }
    if (m_isNew) m_disturbed = false;
    m_isNew = m_damps = false;
    return now;
}

/// Of their impulses, at the mean of the body's motions at the two poses: none where they hold it.
double BodyMotion::workOfOthers(const Inertia& inertia) const {
    return inertia.mass * m_velocityChange.dot(m_settledVelocity + m_motion.velocity) / 2 +
           m_angularImpulse.dot(m_settledSpin + m_motion.spin) / 2;
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

void BodyMotion::depart(const Inertia& inertia, const StepperDef& def, const LoadField& ahead, double dt) {
    m_knowsLoadAhead = mustLookAhead(def, dt);
    m_isCalm = ahead.isCalm();
    if (!m_isCalm) m_available = m_energy;
    m_workOfField = 0;
    m_carriedForce.setZero();
    m_carriedTorque.setZero();
    m_weightOfArrival = 1;
    flyExplicitly(inertia, def, dt);
    m_isUnresolved = m_flight.departure.spin.squaredNorm() * dt * dt > def.turnLimit * def.turnLimit;
    if (m_knowsLoadAhead) flyWithCare(inertia, def, ahead, dt);
    m_available += m_workOfField;
    m_dissipated = m_flight.dissipated;
    m_disturbed = false;
    m_velocityChange.setZero();
    m_angularImpulse.setZero();
    m_isAtEase = m_isCalm && m_linearRelief.isNone() && m_angularRelief.isNone() &&
                 !(m_knowsLoadAhead || m_isUnresolved);
}

void BodyMotion::departAgain(const Inertia& inertia, const StepperDef& def, const LoadField& ahead,
                             double dt) {
    prepareKick(inertia, dt);
    m_damps = false;
    depart(inertia, def, ahead, dt);
}

void BodyMotion::put(const Inertia& inertia, ArrivalRows& arrivals, int lane) const {
    const Motion& arrival = m_flight.arrival;
    bullet_buoyancy::put(arrival.pose, arrivals.pose, lane);
    bullet_buoyancy::put(arrival.velocity, arrivals.moving.velocity, lane);
    bullet_buoyancy::put(arrival.momentum, arrivals.moving.momentum, lane);
    bullet_buoyancy::put(arrival.spin, arrivals.moving.spin, lane);
    arrivals.dissipated.byDrag.lane[lane] = m_dissipated.byDrag;
    arrivals.dissipated.byDamping.lane[lane] = m_dissipated.byDamping;
    arrivals.available.lane[lane] = m_available;
    arrivals.mass.lane[lane] = inertia.mass;
    bullet_buoyancy::put(inertia.inversePrincipal, arrivals.inversePrincipal, lane);
}

void BodyMotion::stepCalmly(const CalmStepRows& steps, const LoadRows& loads, int lane) {
    Motion &departure = m_flight.departure, &arrival = m_flight.arrival;
    m_evaluations = 1;
    m_arrivalVelocity = arrival.velocity;
    m_arrivalMomentum = arrival.momentum;
    m_motion.pose = departure.pose = arrival.pose;
    get(steps.settled, lane, m_motion);
    get(loads, lane, m_load);
    m_ledger.toDrag += steps.dissipated.byDrag.lane[lane];
    m_ledger.toDamping += steps.dissipated.byDamping.lane[lane];
    m_energy = steps.energy.lane[lane];
    m_available = steps.available.lane[lane];
    get(steps.settled.velocity, lane, m_settledVelocity);
    get(steps.settled.spin, lane, m_settledSpin);

    get(steps.departing, lane, departure);
    get(steps.target, lane, arrival.pose);
    get(steps.departing.velocity, lane, arrival.velocity);
    get(steps.departing.momentum, lane, arrival.momentum);
    get(steps.spinAtTarget, lane, arrival.spin);
    get(steps.dissipatedNext, lane, m_flight.dissipated);
    get(steps.dissipatedNext, lane, m_dissipated);
}

/// All of the flight but the load at its end.
void BodyMotion::flyExplicitly(const Inertia& inertia, const StepperDef& def, double dt) {
    m_kick.extraForce = linearRelief() * m_kick.linear.lostInTwoSteps();
    m_kick.extraTorque = angularRelief() * m_kick.angular.lostInTwoSteps();
    const double share = isHeld() ? shareWhileHeld(m_load, m_motion, inertia, def.size, dt) : 1;
    Motion& departure = m_flight.departure;
    departure = leaving();
    m_flight.dissipated = m_kick.apply(departure, inertia, share == 1 ? m_push : share * m_push);
    m_flight.arrival = fly(departure, inertia, dt, turningOf(inertia, def.scheme), def.turnLimit);
}

/// Looks at where the explicit flight under way would end, and takes another if need be. A leapfrog strays in
/// its turning points by phase^4 / 8 of the energy of an oscillation, whose motion has come down to phase^2 /
/// 4 of it by then. A flight that ends where energy forbids is not taken.
void BodyMotion::flyWithCare(const Inertia& inertia, const StepperDef& def, const LoadField& ahead,
                             double dt) {
    m_flight.load = ahead.at(m_flight.arrival.pose);
    ++m_evaluations;
    Mat6 stiffness;
    const auto lookFromHere = [&] {
        ++m_evaluations;
        return ahead.at(m_motion.pose, &stiffness);
    };
    if (!m_isCalm) m_loadFromHere = lookFromHere();
    double phase2 = phaseSquared(loadFromHere(), m_flight, inertia, dt);
    if (!m_isCalm)
        phase2 = std::max(phase2, phaseSquaredOfField(m_load, m_loadFromHere, stiffness,
                                                      m_motion.pose.orientation, inertia, def.size, dt));
    const double phase = std::sqrt(phase2);
    const auto isAllowed = [&](const Flight& flight, double strayed) {
        m_workOfField = workOfField(flight);
        return isWithinEnergy(flight, inertia, ahead.up(), strayed, dt);
    };
    const double stillExplicit = m_disturbed ? resolvedPhase : explicitPhase;
    if (phase <= stillExplicit && isAllowed(m_flight, phase2 / 2) &&
        (m_isCalm || keepsEnergy(m_flight, inertia, stillExplicit, dt)))
        return;

    m_isUnresolved = true;
    if (m_isCalm) lookFromHere();
    const FlightStart start{leaving(), m_load, stiffness, def.turnLimit,
                            m_isCalm ? nullptr : &m_loadFromHere};
    constexpr double converged = 1e-3;  // what Newton's method leaves
    const double implicitness = smoothStep((phase - resolvedPhase) / (unresolvedPhase - resolvedPhase));
    m_flight = flyImplicitly(start, inertia, ahead, implicitness, dt);
    if (implicitness < 1 && !isAllowed(m_flight, converged))
        m_flight = flyImplicitly(start, inertia, ahead, 1, dt);
    if (m_damps && !isAllowed(m_flight, 0)) m_flight = slideAlong(inertia, ahead, dt);
}

/// Across `up`, without turning: in a calm field the load stays as it is.
Flight BodyMotion::slideAlong(const Inertia& inertia, const LoadField& ahead, double dt) {
    Flight flight;
    flight.departure = leaving();
    flight.departure.velocity -= ahead.up().dot(leaving().velocity) * ahead.up();
    flight.departure.setSpin(inertia, Vec3::Zero());
    flight.arrival = fly(flight.departure, inertia, dt, Turning::atSpin);
    flight.load = ahead.at(flight.arrival.pose);
    ++m_evaluations;
    return flight;
}

/// What its change does to the body on a flight: implicit Euler has it act at the pose that the body leaves,
/// the trapezoidal rule in equal parts there and where it arrives. What it does there is told from the change
/// of the load: between nothing and twice as much.
double BodyMotion::workOfField(const Flight& flight) const {
    if (m_isCalm) return 0;
    const Pose &from = m_motion.pose, &to = flight.arrival.pose;
    const Vec3 turn = rotationVector(to.orientation * from.orientation.conjugate());
    const double here = m_loadFromHere.potential - m_load.potential, most = std::abs(here);
    const double less = (m_loadFromHere.force - m_load.force).dot(to.position - from.position) +
                        (m_loadFromHere.torque - m_load.torque).dot(turn);
    const double ofArrival = std::min(0.5, m_weightOfArrival);
    return here - ofArrival * std::clamp(less, -most, most);
}

/// At its end, to `strayed` of the energy with which the body moves against the load; or at least not farther
/// without than it began.
bool BodyMotion::isWithinEnergy(const Flight& flight, const Inertia& inertia, const Vec3& up, double strayed,
                                double dt) const {
    if (flight.load.potential <= loadFromHere().potential) return true;
    const double moving = kineticEnergy(leaving(), inertia) - keptEnergy(leaving(), inertia, up);
    const FlightEnd end = m_isCalm ? FlightEnd{flight.arrival, m_available} : endOf(flight, inertia, dt);
    const double limit = end.available - keptEnergy(end.motion, inertia, up) + strayed * moving;
    return flight.load.potential <= limit;
}

/// Where the field is not calm: the load acts across `up`, too, and field and medium may give.
BodyMotion::FlightEnd BodyMotion::endOf(const Flight& flight, const Inertia& inertia, double dt) const {
    FlightEnd end{flight.arrival, m_available + m_workOfField};
    Dissipation taken = flight.dissipated;
    taken += Kick(flight.load, dt)
                 .apply(end.motion, inertia, m_carriedForce + m_weightOfArrival * flight.load.force,
                        m_carriedTorque + m_weightOfArrival * flight.load.torque);
    end.available -= std::min(0.0, taken.sum());
    return end;
}

/// To what the leapfrog strays at a phase: by phase^2 / 4 of the change of an oscillation's potential.
bool BodyMotion::keepsEnergy(const Flight& flight, const Inertia& inertia, double phase, double dt) const {
    const FlightEnd end = endOf(flight, inertia, dt);
    const double moved = std::abs(flight.load.potential - m_loadFromHere.potential),
                 ofField = std::abs(m_workOfField);
    return totalEnergy(end.motion, inertia, flight.load) <=
           end.available + phase * phase / 4 * (moved + 2 * ofField);
}

Flight BodyMotion::flyImplicitly(const FlightStart& start, const Inertia& inertia, const LoadField& ahead,
                                 double implicitness, double dt) {
    const Flight flight = bullet_buoyancy::flyImplicitly(start, inertia, implicitness, dt, ahead);
    m_evaluations += flight.evaluations;
    const KickWeights weights(implicitness);
    m_carriedForce = weights.lastOfStart * m_load.force;
    m_carriedTorque = weights.lastOfStart * m_load.torque;
    m_weightOfArrival = weights.lastOfEnd;
    m_damps = implicitness > 0;
    return flight;
}

}  // namespace bullet_buoyancy
