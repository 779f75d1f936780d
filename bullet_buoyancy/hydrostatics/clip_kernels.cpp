#include "bullet_buoyancy/hydrostatics/clip_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(ClipKernels<float>, chooseSingle, clipSingle)
BULLET_BUOYANCY_CHOOSE_KERNELS(ClipKernels<double>, chooseFull, clipFull)

template <>
const ClipKernels<float>& clipKernels(InstructionSet set) {
    return chooseSingle(set);
}

template <>
const ClipKernels<double>& clipKernels(InstructionSet set) {
    return chooseFull(set);
}

}  // namespace bullet_buoyancy
