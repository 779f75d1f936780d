#pragma once

#include "bullet_buoyancy/bullet/calm_rows.h"
#include "bullet_buoyancy/bullet/floating_body.h"

namespace bullet_buoyancy {

/// Steps bodies that rock or lie in calm water side by side. What comes out for a body does not depend on the
/// others.
class CalmBlock {
public:
    /// For one substep of `dt` (s).
    CalmBlock(const WaterNow& water, double dt);

    /// Whether there can be any such body.
    static bool isFor(const WaterNow& water) {
        return water.bounds.isLevel() && water.bounds.isFlat() && water.bounds.still;
    }

    /// `body.isAtEase()`. Steps the block when it is full.
    void add(FloatingBody& body);

    /// All that were added; those that turn out not to be calm as `FloatingBody::step` does.
    void step();

private:
    const WaterNow& m_water;
    double m_dt;
    LevelWater m_level;
    int m_count = 0;
    FloatingBody* m_bodies[blockSize];
    CalmRows m_rows;
};

}  // namespace bullet_buoyancy
