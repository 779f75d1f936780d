#include "bullet_buoyancy/bullet/body_status.h"

namespace bullet_buoyancy {

std::string BodyStatus::describe() const {
    switch (error) {
        case BodyError::none:
            break;
        case BodyError::alreadyAdded:
            return "the body has been added before";
        case BodyError::notAdded:
            return "the body has not been added";
        case BodyError::idTaken:
            return "another body has the same id";
        case BodyError::staticBody:
            return "the body is static (mass 0): it cannot float";
        case BodyError::kinematicBody:
            return "the body is kinematic: it is moved by the user, not by water";
        case BodyError::noShape:
            return "the body has no collision shape, and no hull was given";
        case BodyError::notFinite:
            return "the body's pose, velocity, mass or inertia is not finite";
        case BodyError::badSettings:
            return "drag or damping is negative or not finite";
        case BodyError::badHull:
            return "its hull was refused: " + hull.describe();
    }
    const std::string rotation =
        canTurn ? "" : "; its inverse inertia has zeros: about those axes nothing turns it";
    return hull.describe() + rotation;
}

}  // namespace bullet_buoyancy
