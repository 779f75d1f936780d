#include "bullet_buoyancy/hydrostatics/wet_kernels.h"

#include "bullet_buoyancy/core/choose_kernels.h"

namespace bullet_buoyancy {

BULLET_BUOYANCY_CHOOSE_KERNELS(WetKernels, wetKernels, wetTriangles)

}  // namespace bullet_buoyancy
