#include "bullet_buoyancy/motion/calm_step_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(CalmStepKernels, calmStepKernels, calmStepKernels)

}  // namespace bullet_buoyancy
