#include "bullet_buoyancy/hydrostatics/wet_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const WetKernels wetTriangles;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const WetKernels wetTriangles;
}

namespace avx512 {
extern const WetKernels wetTriangles;
}
#endif

const WetKernels& wetKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::wetTriangles;
    if (set == InstructionSet::avx2) return avx2::wetTriangles;
#endif
    static_cast<void>(set);
    return portable::wetTriangles;
}

}  // namespace bullet_buoyancy
