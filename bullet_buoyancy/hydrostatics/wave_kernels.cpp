#include "bullet_buoyancy/hydrostatics/wave_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const WaveKernels wetInWaves;
}

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const WaveKernels wetInWaves;
}

namespace avx512 {
extern const WaveKernels wetInWaves;
}
#endif

const WaveKernels& waveKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::wetInWaves;
    if (set == InstructionSet::avx2) return avx2::wetInWaves;
#endif
    static_cast<void>(set);
    return portable::wetInWaves;
}

}  // namespace bullet_buoyancy
