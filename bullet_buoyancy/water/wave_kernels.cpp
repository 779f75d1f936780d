#include "bullet_buoyancy/water/wave_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const WaveKernels waveKernels;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const WaveKernels waveKernels;
}

namespace avx512 {
extern const WaveKernels waveKernels;
}
#endif

const WaveKernels& waveKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::waveKernels;
    if (set == InstructionSet::avx2) return avx2::waveKernels;
#endif
    static_cast<void>(set);
    return portable::waveKernels;
}

}  // namespace bullet_buoyancy
