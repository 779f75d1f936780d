#include "bullet_buoyancy/hydrostatics/clip_kernels.h"

namespace bullet_buoyancy {

namespace portable {
extern const ClipKernels<float> clipSingle;
extern const ClipKernels<double> clipFull;
}  // namespace portable

#ifdef BULLET_BUOYANCY_X86_KERNELS
namespace avx2 {
extern const ClipKernels<float> clipSingle;
extern const ClipKernels<double> clipFull;
}  // namespace avx2

namespace avx512 {
extern const ClipKernels<float> clipSingle;
extern const ClipKernels<double> clipFull;
}  // namespace avx512
#endif

template <>
const ClipKernels<float>& clipKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::clipSingle;
    if (set == InstructionSet::avx2) return avx2::clipSingle;
#endif
    static_cast<void>(set);
    return portable::clipSingle;
}

template <>
const ClipKernels<double>& clipKernels(InstructionSet set) {
#ifdef BULLET_BUOYANCY_X86_KERNELS
    if (set == InstructionSet::avx512) return avx512::clipFull;
    if (set == InstructionSet::avx2) return avx2::clipFull;
#endif
    static_cast<void>(set);
    return portable::clipFull;
}

}  // namespace bullet_buoyancy
