#pragma once

#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/hydrostatics/hydrostatics.h"
#include "bullet_buoyancy/hydrostatics/level_rows.h"

namespace bullet_buoyancy {

/// What closed hulls without solids of revolution displace of level water, as `evaluate` finds it but for
/// rounding. What comes out for a body does not depend on the others of its block.
class BlockDisplacement {
public:
    /// `hull` must live until the block is taken.
    void setHull(int lane, const Hull& hull);

    /// All lanes must have a hull.
    void take(const LevelWater& water, const PoseRows& poses, Precision precision);

    const HullRows& hulls() const { return m_hulls; }
    const DisplacementRows& rows() const { return m_displaced; }

private:
    bool isCut(int lane) const { return m_planes.isCut.lane[lane] > 0; }
    bool haveOnePack() const;
    void pressOne(int lane, Precision precision);
    void finish(int lane, Precision precision);

    const Hull* m_hull[blockSize] = {};
    HullRows m_hulls;
    PlaneRows m_planes;
    PressureSumRows m_sums;
    DisplacementRows m_displaced;
};

}  // namespace bullet_buoyancy
