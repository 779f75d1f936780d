#include "bullet_buoyancy/bullet/handover_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(HandoverKernels, handoverKernels, handoverKernels)

}  // namespace bullet_buoyancy
