#include "bullet_buoyancy/hydrostatics/level_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const LevelKernels levelKernels;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const LevelKernels levelKernels;
}

namespace avx512 {
extern const LevelKernels levelKernels;
}
#endif

const LevelKernels& levelKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::levelKernels;
    if (set == InstructionSet::avx2) return avx2::levelKernels;
#endif
    static_cast<void>(set);
    return portable::levelKernels;
}

}  // namespace bullet_buoyancy
