#include "bullet_buoyancy/water/wave_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(WaveKernels, waveKernels, waveKernels)

}  // namespace bullet_buoyancy
