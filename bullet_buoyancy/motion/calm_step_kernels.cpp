#include "bullet_buoyancy/motion/calm_step_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const CalmStepKernels calmStepKernels;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const CalmStepKernels calmStepKernels;
}

namespace avx512 {
extern const CalmStepKernels calmStepKernels;
}
#endif

const CalmStepKernels& calmStepKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::calmStepKernels;
    if (set == InstructionSet::avx2) return avx2::calmStepKernels;
#endif
    static_cast<void>(set);
    return portable::calmStepKernels;
}

}  // namespace bullet_buoyancy
