#pragma once

#include "bullet_buoyancy/core/instruction_set.h"
#include "bullet_buoyancy/hull/packs.h"
#include "bullet_buoyancy/hydrostatics/level_rows.h"

namespace bullet_buoyancy {

/// A block of bodies in level water, side by side. Each instruction set reckons alike: results are the same
/// to the last bit.
struct LevelKernels {
    void (*see)(const LevelWater& water, const PoseRows& poses, const HullRows& hulls, PlaneRows& planes);

    /// What the first `count` triangles of a pack come to for bodies that have one hull, to the last bit as
    /// by ClipKernels for each.
    void (*press)(const TrianglePack<double>& pack, int count, const PlaneRows& planes,
                  PressureSumRows& sums);

    /// From the sums, or in closed form where the surface cuts nothing; without error.
    void (*displace)(const HullRows& hulls, const PlaneRows& planes, const PressureSumRows& sums,
                     DisplacementRows& displaced);
};

const LevelKernels& levelKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
