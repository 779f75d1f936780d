#include "bullet_buoyancy/hydrostatics/level_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(LevelKernels, levelKernels, levelKernels)

}  // namespace bullet_buoyancy
