#pragma once

#include <cstdint>
#include <memory>

#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/motion/body_motion.h"

namespace bullet_buoyancy {

/// How one body meets the water. The defaults are those published as about right for crates in water.
struct BodyDef {
    /// What the water wets, about the centre of mass; null: read from the body's collision shape.
    std::shared_ptr<const Hull> hull;

    double linearDrag = 3;  ///< rate at which velocity relative to the water decays under water, 1/s
    double angularDamping =
        1.01;  ///< rate at which angular momentum decays under water, 1/s; see `dampingRate`

    /// Drag and damping in proportion to the share of the volume that is wet; false: in full whenever wet.
    bool scaleByWetFraction = true;

    StepScheme scheme = StepScheme::guarded;  ///< the other is for comparisons

    /// By which a saved state knows the body, unlike any other's of the action. Bodies of id 0 are known by
    /// the order in which they were added.
    std::uint64_t id = 0;
};

}  // namespace bullet_buoyancy
