#pragma once

#include "bullet_buoyancy/core/body_rows.h"
#include "bullet_buoyancy/core/instruction_set.h"

namespace bullet_buoyancy {

/// Bodies of a block as they come back from Bullet's step.
struct ReturnRows {
    VectorRows axes[3];  ///< rows of the basis
    VectorRows position, velocity;
    VectorRows given;       ///< the velocity that Bullet was given, m/s
    VectorRows force;       ///< in all, N
    VectorRows gravity;     ///< m/s^2
    BodyRow inverseMass;    ///< 1/kg
    BodyRow longestStep;    ///< see Handover, s
    BodyRow isUndisturbed;  ///< 1 if gravity acted, nobody else, and the body is at its target; else 0
};

/// What Bullet is given.
struct GiftRows {
    VectorRows correction;  ///< the part of the velocity that only moves Bullet's body to ours, m/s
    VectorRows velocity, spin;
};

/// See Handover, of bodies with linear factors of 1. `rounding`: share of themselves to which Bullet rounds
/// numbers. Results are the same to the last bit by each instruction set.
struct HandoverKernels {
    /// Whether they came back `atTarget`. What is nearly there may be told to be disturbed.
    void (*take)(const PoseRows& targets, double dt, double rounding, ReturnRows& returns);

    /// From poses which Bullet's bodies have but for their position.
    void (*give)(const PoseRows& poses, const ReturnRows& returns, const VectorRows& departure,
                 const PoseRows& targets, double dt, double rounding, GiftRows& gifts);
};

const HandoverKernels& handoverKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
