# What the machine that runs the library may have beyond the machine that it is built for.
set(buoyancy_instruction_sets portable)
# CMAKE_SYSTEM_PROCESSOR is the host's where Xcode or Visual Studio build for another. On Windows g++ aligns the
# stack for no more than 16 bytes, and vectors on it crash (GCC bug 54412).
if(BULLET_BUOYANCY_SIMD AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_SIZEOF_VOID_P EQUAL 8
        AND NOT CMAKE_OSX_ARCHITECTURES MATCHES "arm64" AND NOT CMAKE_CXX_COMPILER_ARCHITECTURE_ID MATCHES "ARM"
        AND NOT (MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"))
    list(APPEND buoyancy_instruction_sets avx2 avx512)
    if(MSVC)
        set(buoyancy_options_avx2 /arch:AVX2)
        set(buoyancy_options_avx512 /arch:AVX512)
    else()
        set(buoyancy_options_avx2 -mavx2)
        set(buoyancy_options_avx512 -mavx512f -mavx512bw -mavx512dq -mavx512vl)
    endif()
endif()

# buoyancy_add_kernels(<target> <source>...)
#
# Compiles each source once for each instruction set, in a namespace of that name, into the target, whose
# own code takes the best that the running machine has: see core/instruction_set.h.
function(buoyancy_add_kernels target)
    foreach(set IN LISTS buoyancy_instruction_sets)
        set(kernels ${target}_${set})
        add_library(${kernels} OBJECT ${ARGN})
        buoyancy_library_settings(${kernels})
        target_compile_definitions(${kernels} PRIVATE BULLET_BUOYANCY_KERNEL=${set})
        target_compile_options(${kernels} PRIVATE ${buoyancy_options_${set}})
        if(NOT BULLET_BUOYANCY_SIMD)
            target_compile_definitions(${kernels} PRIVATE BULLET_BUOYANCY_NO_VECTORS)
        endif()
        target_link_libraries(${kernels} PRIVATE Eigen3::Eigen)
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
    endforeach()
    if(avx2 IN_LIST buoyancy_instruction_sets)
        target_compile_definitions(${target} PRIVATE BULLET_BUOYANCY_X86_KERNELS)
    endif()
endfunction()
