#pragma once

// Only kernels include this. Each is compiled once for each instruction set, in a namespace of its own that
// the build names, so that no function for a newer machine is ever linked into code for all of them. For the
// same reason it includes nothing that has inline functions.
#ifndef BULLET_BUOYANCY_KERNEL
#error "lanes.h is for kernels, see buoyancy_add_kernels in cmake/Kernels.cmake"
#endif

#include <cstdint>

#if defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)  // fused multiply-adds round differently: see cmake/CompileSettings.cmake
#endif

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

// As many numbers as a register holds, and the outcome of comparing them: with arithmetic, comparisons,
// & | ^ between outcomes, and `outcome ? a : b`, number by number. One number where the build is without
// vectors; what follows from it is the same to the last bit.
#if defined(__GNUC__) && !defined(BULLET_BUOYANCY_NO_VECTORS)

#if defined(__AVX512F__)
#define BULLET_BUOYANCY_REGISTER 64
#elif defined(__AVX__)
#define BULLET_BUOYANCY_REGISTER 32
#else
#define BULLET_BUOYANCY_REGISTER 16
#endif

template <typename Real>
struct LanesOf;

template <>
struct LanesOf<float> {
    typedef float Numbers __attribute__((vector_size(BULLET_BUOYANCY_REGISTER)));
    typedef std::int32_t Truths __attribute__((vector_size(BULLET_BUOYANCY_REGISTER)));
};

template <>
struct LanesOf<double> {
    typedef double Numbers __attribute__((vector_size(BULLET_BUOYANCY_REGISTER)));
    typedef std::int64_t Truths __attribute__((vector_size(BULLET_BUOYANCY_REGISTER)));
    typedef std::uint64_t Bits __attribute__((vector_size(BULLET_BUOYANCY_REGISTER)));
};

/// Of eight numbers at an address that is a multiple of their size, always in the same order.
inline double sumOfEight(const double* from) {
    typedef double Four __attribute__((vector_size(32)));
    typedef double Two __attribute__((vector_size(16)));
    const Four* halves = reinterpret_cast<const Four*>(from);
    const Four four = halves[0] + halves[1];
    const Two two = Two{four[0], four[1]} + Two{four[2], four[3]};
    return two[0] + two[1];
}

#else

template <typename Real>
struct LanesOf {
    using Numbers = Real;
    using Truths = bool;
    using Bits = std::uint64_t;
};

inline double sumOfEight(const double* from) {
    return ((from[0] + from[4]) + (from[2] + from[6])) + ((from[1] + from[5]) + (from[3] + from[7]));
}

#endif

template <typename Real>
using Lanes = typename LanesOf<Real>::Numbers;
template <typename Real>
using Truths = typename LanesOf<Real>::Truths;

template <typename Real>
inline constexpr int laneCount = int(sizeof(Lanes<Real>) / sizeof(Real));

/// All lanes the same.
template <typename Real>
inline Lanes<Real> spread(Real value) {
    return value - Lanes<Real>{};  // which is the value, whatever its sign
}

/// Numbers and the bits that they are made of.
union NumbersOrBits {
    Lanes<double> numbers;
    LanesOf<double>::Bits bits;
};

/// From an address that is a multiple of the register's size.
template <typename Real>
inline Lanes<Real> load(const Real* from) {
    return *reinterpret_cast<const Lanes<Real>*>(from);
}

template <typename Real>
inline void store(const Lanes<Real>& lanes, Real* to) {
    *reinterpret_cast<Lanes<Real>*>(to) = lanes;
}

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
