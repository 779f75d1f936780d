#include "bullet_buoyancy/bullet/action_state.h"

namespace bullet_buoyancy {

namespace {

std::string named(const RestoreStatus& status) {
    const std::string id = status.id == 0 ? "" : " (id " + std::to_string(status.id) + ")";
    return "body " + std::to_string(status.body) + id;
}

}  // namespace

std::string RestoreStatus::describe() const {
    switch (error) {
        case RestoreError::none:
            return "restored";
        case RestoreError::notAState:
            return "these bytes are no state of a buoyancy action";
        case RestoreError::otherVersion:
            return "the state was saved by another version of the library";
        case RestoreError::otherPrecision:
            return "the state was saved with Bullet of another precision";
        case RestoreError::damaged:
            return "the state was cut short or changed";
        case RestoreError::otherSettings:
            return "the state was saved by an action of other settings";
        case RestoreError::otherBodies:
            return "the action has other bodies than the state, which differ from " + named(*this) + " on";
        case RestoreError::otherHull:
            return named(*this) + " of the state had another hull";
        case RestoreError::otherInertia:
            return named(*this) + " of the state had another mass, inertia or factor";
    }
    return "";
}

}  // namespace bullet_buoyancy
