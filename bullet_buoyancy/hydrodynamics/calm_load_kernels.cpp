#include "bullet_buoyancy/hydrodynamics/calm_load_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const CalmLoadKernels calmLoadKernels;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const CalmLoadKernels calmLoadKernels;
}

namespace avx512 {
extern const CalmLoadKernels calmLoadKernels;
}
#endif

const CalmLoadKernels& calmLoadKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::calmLoadKernels;
    if (set == InstructionSet::avx2) return avx2::calmLoadKernels;
#endif
    static_cast<void>(set);
    return portable::calmLoadKernels;
}

}  // namespace bullet_buoyancy
