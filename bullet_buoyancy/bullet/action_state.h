#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bullet_buoyancy {

/// All that the next step of a BuoyancyAction depends on and that steps change, with the same of its bodies'
/// Bullet state: see `BuoyancyAction::save`. Plain bytes, to copy, compare (equal states have equal bytes),
/// send and store: the same on any machine, with a mark, a version, Bullet's precision and a check sum in
/// them.
struct ActionState {
    std::vector<std::byte> bytes;  ///< empty until something is saved
};

/// Why a state cannot be restored.
enum class RestoreError {
    none,            ///< it was
    notAState,       ///< not written by `save`
    otherVersion,    ///< by a version of the library that keeps other things
    otherPrecision,  ///< with Bullet of another precision
    damaged,         ///< cut short or changed
    otherSettings,   ///< the action's `BuoyancySettings` were others
    otherBodies,     ///< the action lacks a body, or has one too many
    otherHull,       ///< a body's hull was another
    otherInertia,    ///< a body's mass, inertia or factors were others
};

/// Whether the action is where the state was saved, and if not, why. It is then as it was before.
struct RestoreStatus {
    RestoreError error = RestoreError::none;  ///< why not
    std::size_t body = 0;  ///< of the state, the first that differs: the number of those added before it
    std::uint64_t id = 0;  ///< its `BodyDef::id`

    /// It is.
    bool ok() const { return error == RestoreError::none; }
    /// As `ok`.
    explicit operator bool() const { return ok(); }

    /// One line for people.
    std::string describe() const;
};

}  // namespace bullet_buoyancy
