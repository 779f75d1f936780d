#pragma once

#include "bullet_buoyancy/motion/calm_step_kernels.h"
#include "bullet_buoyancy/motion/energy_ledger.h"
#include "bullet_buoyancy/motion/implicit_flight.h"
#include "bullet_buoyancy/motion/kick.h"

namespace bullet_buoyancy {

/// How a body is stepped.
enum class StepScheme {
    /// As implicit as the body needs, and no more; holds it to the energy that is there.
    guarded,
    /// One explicit impulse, and the spin of the step's start: as published, for comparison. Light and small
    /// bodies explode, and fast spins gain energy.
    published,
};

/// Between two poses.
inline Turning turningOf(const Inertia& inertia, StepScheme scheme) {
    return inertia.turnsFreely && scheme == StepScheme::guarded ? Turning::byMomentum : Turning::atSpin;
}

/// What the stepper must know of a body beside its inertia.
struct StepperDef {
    StepScheme scheme = StepScheme::guarded;
    double size = 1;                 ///< largest distance of a wetted point from the centre of mass, m
    double turnLimit = largestTurn;  ///< the farthest that the body can be turned in the next step, rad
    double stiffestRate2 = 0;  ///< upper estimate of the square of the body's fastest oscillation, 1/s^2
};

/// What contacts, joints and the user did to a body on its way from one pose to the next.
struct Disturbance {
    Vec3 velocityChange = Vec3::Zero();  ///< m/s
    Vec3 spinChange = Vec3::Zero();  ///< rad/s, at the orientation of departure, where engines solve for it
    bool turnedByHand = false;       ///< it is not where its spin takes it: it goes on at the same spin
};

/// The owner of a body's motion: pose, velocity and angular momentum are its state, in double precision. The
/// engine is given what carries the body from pose to pose, and what others do to the body on the way enters
/// the state as an impulse.
///
/// In a calm field (see LoadField) the body is held to the energy that is left of its start's. In any other,
/// what a flight that is not resolved may have is that with which it began, and the work of the field.
///
/// Each step: one of `start`, `arrive`, `arriveElsewhere`; then `settle`; then `depart`.
class BodyMotion {
public:
    /// Forgets the past: the body is where, and moves as, `motion` says.
    void start(const Motion& motion);

    /// At the target of `depart`.
    void arrive() { m_motion = m_flight.arrival; }

    /// The same, off the target by `offset` (m), which takes no energy.
    void arriveBeside(const Vec3& offset);

    /// Others acted on the way.
    void arriveElsewhere(const Inertia& inertia, const Pose& pose, const Disturbance& disturbance);

    /// The field at the end of the step is not the one that was shown when it began.
    void forgetLoadAhead() { m_knowsLoadAhead = false; }

    /// From the end of the step on, another load acts on the body: others have changed what it is. Its motion
    /// goes on; the change of its potential is their work.
    void meetOtherLoad() {
        forgetLoadAhead();
        m_disturbed = true;
        m_isAtEase = false;
    }

    /// Ends the step: after it, `motion` is that at the pose, and `load` what acts there. `now`: the field at
    /// this moment.
    void settle(const Inertia& inertia, const StepperDef& def, const LoadField& now, double dt);

    /// Begins the next step: with `departure`, to `target`. `ahead`: the field after `dt` (s).
    void depart(const Inertia& inertia, const StepperDef& def, const LoadField& ahead, double dt);

    /// In place of the last time, since the step was of another length.
    void departAgain(const Inertia& inertia, const StepperDef& def, const LoadField& ahead, double dt);

    /// Whether CalmStepKernels may take its next step, guarded and of `dt` (s), if it arrives at the target:
    /// it was not disturbed for two steps, is owed no part of a load, and need not look ahead.
    bool isAtEase(const StepperDef& def, double dt) const {
        return m_isAtEase && def.stiffestRate2 * dt * dt <= safePhase * safePhase;
    }

    /// What the kernels take of it, `length` aside.
    void put(const Inertia& inertia, ArrivalRows& arrivals, int lane) const;

    /// As the kernels found it, in place of `arrive`, `settle` and `depart`.
    void stepCalmly(const CalmStepRows& steps, const LoadRows& loads, int lane);

    const Motion& motion() const { return m_motion; }
    const Motion& departure() const { return m_flight.departure; }
    const Pose& target() const { return m_flight.arrival.pose; }
    const Load& load() const { return m_load; }
    const EnergyLedger& ledger() const { return m_ledger; }
    double linearRelief() const { return m_linearRelief.share(); }
    double angularRelief() const { return m_angularRelief.share(); }

    /// How often the load was evaluated since the last call of `settle`, that call included.
    int evaluations() const { return m_evaluations; }

private:
    friend struct StateMembers;  // saves and restores them

    /// Phases, in rad a step, of the fastest oscillation that a body can have (StepperDef) up to which one
    /// look at its pose is enough. A body that others touch needs a second look for the one ahead, and strays
    /// by their doing anyway.
    static constexpr double safePhase = 0.2, safePhaseInTouch = 0.5;

    /// After the kick that ends a flight, with the most energy that the body may have then, J.
    struct FlightEnd {
        Motion motion;
        double available;
    };

    void prepareKick(const Inertia& inertia, double dt);
    Dissipation endStep(Motion& motion, const Inertia& inertia, double share) const;
    void evaluate(const LoadField& now);
    void noteOthers();
    void spend(double now);
    double account(const Inertia& inertia, bool calm, bool foreseen);
    double workOfOthers(const Inertia& inertia) const;
    bool isHeld() const;
    bool mustLookAhead(const StepperDef& def, double dt) const;
    void flyExplicitly(const Inertia& inertia, const StepperDef& def, double dt);
    void flyWithCare(const Inertia& inertia, const StepperDef& def, const LoadField& ahead, double dt);
    Flight flyImplicitly(const FlightStart& start, const Inertia& inertia, const LoadField& ahead,
                         double implicitness, double dt);
    Flight slideAlong(const Inertia& inertia, const LoadField& ahead, double dt);
    double workOfField(const Flight& flight) const;
    bool isWithinEnergy(const Flight& flight, const Inertia& inertia, const Vec3& up, double strayed,
                        double dt) const;
    FlightEnd endOf(const Flight& flight, const Inertia& inertia, double dt) const;
    bool keepsEnergy(const Flight& flight, const Inertia& inertia, double phase, double dt) const;
    const Motion& leaving() const { return m_isOwed ? m_leaving : m_motion; }
    const Load& loadFromHere() const { return m_isCalm ? m_load : m_loadFromHere; }

    Motion m_motion;
    Load m_load;
    bool m_isOwed = false;               // others will take what ended the step
    Motion m_leaving;                    // if so: the motion with which the next step begins
    Kick m_kick;                         // by the load, for half a step
    Push m_push;                         // of the load
    Flight m_flight;                     // the one under way
    bool m_knowsLoadAhead = false;       // it was evaluated at the flight's arrival
    bool m_isCalm = true;                // the field that the flight was shown
    Vec3 m_carriedForce = Vec3::Zero();  // what the kick that ends the flight takes from its start
    Vec3 m_carriedTorque = Vec3::Zero();
    double m_weightOfArrival = 1;  // of the load there in that kick
    bool m_damps = false;          // the flight is one that takes energy for good
    bool m_isUnresolved = false;   // the flight takes the body farther than its motion is followed
    bool m_isAtEase = false;       // none of all that, and nobody was in touch: see `isAtEase`

    // What others did on the way.
    bool m_disturbed = true;
    Vec3 m_velocityChange = Vec3::Zero(), m_angularImpulse = Vec3::Zero();
    Vec3 m_arrivalVelocity = Vec3::Zero(), m_arrivalMomentum = Vec3::Zero();  // before `settle`
    Vec3 m_settledVelocity = Vec3::Zero(), m_settledSpin = Vec3::Zero();      // after it
    Relief m_linearRelief, m_angularRelief;

    bool m_isNew = true;
    Dissipation m_dissipated;  // in the step under way
    double m_energy = 0;       // kinetic and potential at the last pose, J
    double m_available = 0;    // the most that it may be, J
    double m_workOfField = 0;  // on the flight under way, as foreseen, J
    EnergyLedger m_ledger;
    int m_evaluations = 0;

    Load m_loadFromHere;  // of a field that is not calm: at the flight's end, at the pose it leaves
};

}  // namespace bullet_buoyancy
