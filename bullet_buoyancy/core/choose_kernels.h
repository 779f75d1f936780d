#pragma once

#include "bullet_buoyancy/core/instruction_set.h"

/// Defines `const Table& function(InstructionSet)`, which chooses among the tables of kernels, each called
/// `name`, that are compiled for one instruction set (see core/lanes.h). To be used in namespace
/// bullet_buoyancy.
#ifdef BULLET_BUOYANCY_X86_KERNELS
#define BULLET_BUOYANCY_CHOOSE_KERNELS(Table, function, name)             \
    namespace portable {                                                  \
    extern const Table name;                                              \
    }                                                                     \
    namespace avx2 {                                                      \
    extern const Table name;                                              \
    }                                                                     \
    namespace avx512 {                                                    \
    extern const Table name;                                              \
    }                                                                     \
    const Table& function(InstructionSet set) {                           \
        if (set == InstructionSet::avx512) return avx512::name;           \
        return set == InstructionSet::avx2 ? avx2::name : portable::name; \
    }
#else
#define BULLET_BUOYANCY_CHOOSE_KERNELS(Table, function, name) \
    namespace portable {                                      \
    extern const Table name;                                  \
    }                                                         \
    const Table& function(InstructionSet) {                   \
        return portable::name;                                \
    }
#endif
