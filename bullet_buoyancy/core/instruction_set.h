#pragma once

namespace bullet_buoyancy {

/// What a processor's vector instructions are called. Kernels are compiled once for each, whatever the
/// machine that builds them, and the best that the running machine has is taken.
enum class InstructionSet {
    portable,  ///< what every machine of the architecture has
    avx2,      ///< x86-64 of 2013 and later
    avx512,    ///< x86-64 of 2017 and later: F, BW, DQ and VL
};

/// The best of this machine for which there are kernels.
InstructionSet bestInstructionSet();

/// "avx2"
const char* nameOf(InstructionSet set);

}  // namespace bullet_buoyancy
