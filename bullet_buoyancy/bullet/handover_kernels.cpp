#include "bullet_buoyancy/bullet/handover_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const HandoverKernels handoverKernels;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const HandoverKernels handoverKernels;
}

namespace avx512 {
extern const HandoverKernels handoverKernels;
}
#endif

const HandoverKernels& handoverKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::handoverKernels;
    if (set == InstructionSet::avx2) return avx2::handoverKernels;
#endif
    static_cast<void>(set);
    return portable::handoverKernels;
}

}  // namespace bullet_buoyancy
