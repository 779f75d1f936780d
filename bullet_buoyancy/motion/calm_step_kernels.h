#pragma once

#include "bullet_buoyancy/core/body_rows.h"
#include "bullet_buoyancy/core/instruction_set.h"

namespace bullet_buoyancy {

/// See Motion, beside the pose.
struct MovingRows {
    VectorRows velocity, momentum, spin;
};

/// See Dissipation.
struct DissipationRows {
    BodyRow byDrag, byDamping;
};

/// Bodies of a block at the end of a flight, undisturbed.
struct ArrivalRows {
    PoseRows pose;
    MovingRows moving;           ///< before the kick that ends the step
    DissipationRows dissipated;  ///< by the kick that began it
    BodyRow available;           ///< the most that the energy may be, before what the medium takes, J
    BodyRow mass;
    VectorRows inversePrincipal;  ///< see Inertia
    BodyRow length;               ///< see isAtRest, m
};

/// What comes of one step.
struct CalmStepRows {
    MovingRows settled;          ///< at the pose
    DissipationRows dissipated;  ///< by the two kicks of the step that has ended
    BodyRow energy, available;   ///< J

    MovingRows departing;
    DissipationRows dissipatedNext;  ///< by the kick that begins the next step
    PoseRows target;
    VectorRows spinAtTarget;

    /// 1, or 0 where the body's motion is not calm enough for this: it turns by more than is gentle, its
    /// rates are high, it has more energy than is available, or something is not finite. The other rows do
    /// not matter then.
    BodyRow isCalm;
    BodyRow isAtRest;  ///< 1 or 0: see `isAtRest`; gravity is that of the water
};

struct CalmStepKernels {
    /// What BodyMotion's `settle` and `depart` come to but for rounding for bodies that turn freely, in a
    /// calm field at rest, without any part of a load owed or carried over. `gravity` in m/s^2, `dt` > 0 in
    /// s. Results are the same to the last bit by each instruction set.
    void (*step)(const ArrivalRows& arrivals, const LoadRows& loads, double gravity, double dt,
                 CalmStepRows& steps);
};

const CalmStepKernels& calmStepKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
