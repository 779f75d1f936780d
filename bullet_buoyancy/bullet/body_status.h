#pragma once

#include <string>

#include "bullet_buoyancy/hull/hull_status.h"

namespace bullet_buoyancy {

/// Why a body does not float.
enum class BodyError {
    none,           ///< it does
    alreadyAdded,   ///< to this action
    notAdded,       ///< the action does not know the body
    idTaken,        ///< another body of the action has the id
    staticBody,     ///< zero mass: nothing to float
    kinematicBody,  ///< moved by the user, not by forces
    noShape,        ///< no collision shape, and no hull given
    notFinite,      ///< pose, velocity, mass or inertia is NaN or infinite
    badSettings,    ///< drag or damping negative or not finite
    badHull,        ///< `BodyStatus::hull` says why
};

/// Whether a body floats from now on as was asked for, and if not, why. A refused body is left as it was.
struct BodyStatus {
    BodyError error = BodyError::none;  ///< why it was refused
    HullStatus hull;                    ///< refusal or remarks; empty for a hull given by the user
    bool canTurn = true;  ///< false: its inverse inertia has zeros, and about those axes nothing turns it

    /// It floats from now on.
    bool ok() const { return error == BodyError::none; }
    /// As `ok`.
    explicit operator bool() const { return ok(); }

    /// One line for people.
    std::string describe() const;
};

}  // namespace bullet_buoyancy
