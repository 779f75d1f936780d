#pragma once

#include "bullet_buoyancy/core/instruction_set.h"
#include "bullet_buoyancy/hydrostatics/level_rows.h"

namespace bullet_buoyancy {

/// How each body of a block meets the water, beside its hull.
struct FloatingRows {
    VectorRows weight;                   ///< world axes, N
    BodyRow linearDrag, angularDamping;  ///< of a body wholly under water, 1/s
    BodyRow scales;                      ///< 1: in proportion to the wet share; 0: in full whenever wet
    BodyRow airRate;                     ///< at which the body is slowed wherever it is, 1/s
};

struct CalmLoadKernels {
    /// What level water at rest and gravity do to each body at its pose. Results are the same to the last bit
    /// by each instruction set. The potential is zero at the water's origin.
    void (*load)(const LevelWater& water, const PoseRows& poses, const HullRows& hulls,
                 const FloatingRows& bodies, const DisplacementRows& displaced, LoadRows& loads);
};

const CalmLoadKernels& calmLoadKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
