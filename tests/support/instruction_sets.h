#pragma once

#include <vector>

#include "bullet_buoyancy/core/instruction_set.h"

namespace bullet_buoyancy::test {

/// All that the machine which runs the tests has.
inline std::vector<InstructionSet> setsOfThisMachine() {
    std::vector<InstructionSet> sets;
    for (InstructionSet set : {InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512})
        if (set <= bestInstructionSet()) sets.push_back(set);
    return sets;
}

}  // namespace bullet_buoyancy::test
