#pragma once

#include <tuple>
#include <type_traits>

#include "bullet_buoyancy/bullet/floating_body.h"
#include "bullet_buoyancy/bullet/rigid_body_state.h"

namespace bullet_buoyancy {

/// What a saved state has of each type, as a tuple of references. A member that is added to a type and not
/// named here does not compile.
struct StateMembers {
    template <class T>
    static auto of(T& value) {
        return list(value, static_cast<std::remove_const_t<T>*>(nullptr));
    }

private:
    template <class T>
    static auto list(T& value, Pose*) {
        auto& [position, orientation] = value;
        return std::tie(position, orientation);
    }
    template <class T>
    static auto list(T& value, Inertia*) {
        auto& [mass, principal, inversePrincipal, linearFactor, angularFactor, turnsFreely] = value;
        return std::tie(mass, principal, inversePrincipal, linearFactor, angularFactor, turnsFreely);
    }
    template <class T>
    static auto list(T& value, Motion*) {
        auto& [pose, velocity, momentum, spin] = value;
        return std::tie(pose, velocity, momentum, spin);
    }
    template <class T>
    static auto list(T& value, Load*) {
        auto& [force, torque, potential, potentialRounding, dragRate, dampingRate, mediumVelocity,
               displacement, centreFromCom, forceErrorBound] = value;
        return std::tie(force, torque, potential, potentialRounding, dragRate, dampingRate, mediumVelocity,
                        displacement, centreFromCom, forceErrorBound);
    }
    template <class T>
    static auto list(T& value, DampedStep*) {
        auto& [rate, dt, decay, gain, gainOfTravel] = value;
        return std::tie(rate, dt, decay, gain, gainOfTravel);
    }
    template <class T>
    static auto list(T& value, Relief*) {
        auto& [last, beforeLast] = value;
        return std::tie(last, beforeLast);
    }
    template <class T>
    static auto list(T& value, Dissipation*) {
        auto& [byDrag, byDamping] = value;
        return std::tie(byDrag, byDamping);
    }
    template <class T>
    static auto list(T& value, Push*) {
        auto& [torque, acceleration, angularAcceleration] = value;
        return std::tie(torque, acceleration, angularAcceleration);
    }
    template <class T>
    static auto list(T& value, Kick*) {
        auto& [linear, angular, mediumVelocity, extraForce, extraTorque] = value;
        return std::tie(linear, angular, mediumVelocity, extraForce, extraTorque);
    }
    template <class T>
    static auto list(T& value, Flight*) {
        auto& [departure, arrival, load, dissipated, evaluations] = value;
        return std::tie(departure, arrival, load, dissipated, evaluations);
    }
    template <class T>
    static auto list(T& value, Disturbance*) {
        auto& [velocityChange, spinChange, turnedByHand] = value;
        return std::tie(velocityChange, spinChange, turnedByHand);
    }
    template <class T>
    static auto list(T& value, EnergyLedger*) {
        auto& [start, byOthers, byWater, toDrag, toDamping] = value;
        return std::tie(start, byOthers, byWater, toDrag, toDamping);
    }
    template <class T>
    static auto list(T& value, BodyMotion*) {
        auto& [motion, load, isOwed, leaving, kick, push, flight, knowsLoadAhead, isCalm, carriedForce,
               carriedTorque, weightOfArrival, damps, isUnresolved, isAtEase, disturbed, velocityChange,
               angularImpulse, arrivalVelocity, arrivalMomentum, settledVelocity, settledSpin, linearRelief,
               angularRelief, isNew, dissipated, energy, available, workOfField, ledger, evaluations,
               loadFromHere] = value;
        return std::tie(motion, load, isOwed, leaving, kick, push, flight, knowsLoadAhead, isCalm,
                        carriedForce, carriedTorque, weightOfArrival, damps, isUnresolved, isAtEase,
                        disturbed, velocityChange, angularImpulse, arrivalVelocity, arrivalMomentum,
                        settledVelocity, settledSpin, linearRelief, angularRelief, isNew, dissipated, energy,
                        available, workOfField, ledger, evaluations, loadFromHere);
    }
    template <class T>
    static auto list(T& value, Handover*) {
        auto& [velocity, spin, correction, start, dt, longestStep, pose, disturbance] = value;
        return std::tie(velocity, spin, correction, start, dt, longestStep, pose, disturbance);
    }
    template <class T>
    static auto list(T& value, BorrowedSettings*) {
        auto& [linearDamping, angularDamping, linearDampingRate, gyroscopicFlags] = value;
        return std::tie(linearDamping, angularDamping, linearDampingRate, gyroscopicFlags);
    }
    /// The id is not part of what is restored, but the key to it; the hull is the user's.
    template <class T>
    static auto list(T& value, BodyDef*) {
        [[maybe_unused]] auto& [hull, linearDrag, angularDamping, scaleByWetFraction, scheme, id] = value;
        return std::tie(linearDrag, angularDamping, scaleByWetFraction, scheme);
    }
    /// All but the body and what follows from its hull and shape.
    template <class T>
    static auto list(T& value, FloatingBody*) {
        [[maybe_unused]] auto& [body, def, state, hasMotion, isPressed, wokenWithoutGravity, waterSamples,
                                size, flexibility, isPlain, inverseMass, inertia, gravity, borrowed, handover,
                                motion, lastSeenVelocity, knownShape, knownScaling] = value;
        return std::tie(def, state, hasMotion, isPressed, wokenWithoutGravity, waterSamples, flexibility,
                        isPlain, inverseMass, inertia, gravity, borrowed, handover, motion, lastSeenVelocity);
    }
    template <class T>
    static auto list(T& value, RigidBodyState*) {
        auto& [transform, interpolation, velocity, spin, interpolationVelocity, interpolationSpin, force,
               torque, gravity, linearDamping, angularDamping, deactivationTime, activation, flags] = value;
        return std::tie(transform, interpolation, velocity, spin, interpolationVelocity, interpolationSpin,
                        force, torque, gravity, linearDamping, angularDamping, deactivationTime, activation,
                        flags);
    }
};

}  // namespace bullet_buoyancy
