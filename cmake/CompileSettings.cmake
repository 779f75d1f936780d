# Gives one of our targets the project's warnings and sanitizers. All of it is private to the target, so that
# nothing reaches the code of those who link it.
function(buoyancy_compile_settings target)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /bigobj)
        target_compile_definitions(${target} PRIVATE _CRT_SECURE_NO_WARNINGS)
    else()
        target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
    endif()
    target_compile_features(${target} PRIVATE cxx_std_17)
    set_target_properties(${target} PROPERTIES
        CXX_EXTENSIONS OFF
        COMPILE_WARNING_AS_ERROR ${BULLET_BUOYANCY_WARNINGS_AS_ERRORS})

    if(BULLET_BUOYANCY_SANITIZE)
        list(JOIN BULLET_BUOYANCY_SANITIZE "," sanitizers)
        target_compile_options(${target} PRIVATE
            -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
        target_link_options(${target} PRIVATE -fsanitize=${sanitizers})
    endif()
    if(BULLET_BUOYANCY_BUILD_FUZZERS)
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
endfunction()

# What our installed libraries have in common beyond that.
function(buoyancy_library_settings target)
    buoyancy_compile_settings(${target})
    target_compile_features(${target} PUBLIC cxx_std_17)
    # Fused multiply-adds round differently, and whether a compiler forms them depends on the machine.
    # (MSVC's own compiler is told in core/lanes.h.)
    target_compile_options(${target} PRIVATE
        $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:$<$<BOOL:${MSVC}>:/clang:>-ffp-contract=off>)
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
        $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>)
    set_target_properties(${target} PROPERTIES
        OUTPUT_NAME ${target}${BUOYANCY_SUFFIX}
        POSITION_INDEPENDENT_CODE ON
        WINDOWS_EXPORT_ALL_SYMBOLS ON
        INSTALL_RPATH $<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>
        VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endfunction()
