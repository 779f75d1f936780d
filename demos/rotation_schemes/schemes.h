#pragma once

#include <vector>

#include "bullet_buoyancy/core/math_types.h"
#include "rotation_schemes/tumbler.h"

namespace bullet_buoyancy::demo {

/// A way to step the rotation of a body on which no torque acts.
struct Scheme {
    const char* name;

    /// `principal`: moments of inertia, kg m^2. `dt`: s.
    void (*step)(const Vec3& principal, Tumbler& body, double dt);
};

const std::vector<Scheme>& schemes();

/// The one of the library, which is among them.
const Scheme& ours();

}  // namespace bullet_buoyancy::demo
