#include "bullet_buoyancy/hydrodynamics/calm_load_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(CalmLoadKernels, calmLoadKernels, calmLoadKernels)

}  // namespace bullet_buoyancy
