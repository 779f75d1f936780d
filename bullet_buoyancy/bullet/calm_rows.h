#pragma once

#include "bullet_buoyancy/bullet/handover_kernels.h"
#include "bullet_buoyancy/hydrodynamics/calm_load_kernels.h"
#include "bullet_buoyancy/hydrostatics/displace_block.h"
#include "bullet_buoyancy/motion/calm_step_kernels.h"

namespace bullet_buoyancy {

/// All of a block's bodies on their way through a step.
struct CalmRows {
    ReturnRows returns;
    ArrivalRows arrivals;
    FloatingRows floating;
    BlockDisplacement displacement;
    LoadRows loads;
    CalmStepRows steps;
    GiftRows gifts;
};

}  // namespace bullet_buoyancy
