#include "bullet_buoyancy/core/instruction_set.h"

#if defined(BULLET_BUOYANCY_X86_KERNELS) && defined(_MSC_VER)
#include <immintrin.h>
#include <intrin.h>
#endif

namespace bullet_buoyancy {

namespace {

#if !defined(BULLET_BUOYANCY_X86_KERNELS)

InstructionSet detect() {
    return InstructionSet::portable;
}

#elif defined(_MSC_VER)

/// Intel's manual, volume 1, chapters 14 and 15: the processor has them, and the system saves their
/// registers.
InstructionSet detect() {
    int leaf1[4], leaf7[4];
    __cpuid(leaf1, 1);
    constexpr int osxsave = 1 << 27;
    if (!(leaf1[2] & osxsave)) return InstructionSet::portable;
    __cpuidex(leaf7, 7, 0);
    const auto saved = _xgetbv(0);
    constexpr unsigned avx2 = 1u << 5, avx512 = 1u << 16 | 1u << 17 | 1u << 30 | 1u << 31;
    const auto has = [&](unsigned features) { return (unsigned(leaf7[1]) & features) == features; };
    if ((saved & 0xe6) == 0xe6 && has(avx2 | avx512)) return InstructionSet::avx512;
    if ((saved & 0x06) == 0x06 && has(avx2)) return InstructionSet::avx2;
    return InstructionSet::portable;
}

#else

InstructionSet detect() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return InstructionSet::avx512;
    if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
    return InstructionSet::portable;
}

#endif

}  // namespace

InstructionSet bestInstructionSet() {
    static const InstructionSet best = detect();
    return best;
}

const char* nameOf(InstructionSet set) {
    switch (set) {
        case InstructionSet::portable:
            return "portable";
        case InstructionSet::avx2:
            return "avx2";
        case InstructionSet::avx512:
            return "avx512";
    }
    return "";
}

}  // namespace bullet_buoyancy
