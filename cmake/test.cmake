# Builds and tests the library in every configuration, from installing what is missing to the sum of all tests:
#
#   cmake [options] -P cmake/test.cmake
#
#   -DPRESETS="release-float;clang-double"   only these configure presets
#   -DFETCH=ON                               dependencies from source, not from packages
#   -DJOBS=4                                 parallel jobs; as many as there are cores when not given

cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake")
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)

buoyancy_provide_dependencies(libassimp-dev libtinygltf-dev povray pkg-config doxygen)

if(NOT JOBS)
    cmake_host_system_information(RESULT JOBS QUERY NUMBER_OF_LOGICAL_CORES)
endif()

# Whether a compiler brings libFuzzer: not every package of clang does.
function(buoyancy_has_fuzzer compiler result)
    file(MAKE_DIRECTORY "${source_dir}/build")
    execute_process(
        COMMAND "${CMAKE_COMMAND}" -E echo "extern \"C\" int LLVMFuzzerTestOneInput(const char*, long) { return 0; }"
        COMMAND "${compiler}" -x c++ - -fsanitize=fuzzer,address,undefined -o "${source_dir}/build/has_fuzzer"
        RESULT_VARIABLE status
        OUTPUT_QUIET ERROR_QUIET)
    file(REMOVE "${source_dir}/build/has_fuzzer")
    if(status EQUAL 0)
        set(${result} TRUE PARENT_SCOPE)
    else()
        set(${result} FALSE PARENT_SCOPE)
    endif()
endfunction()

set(skipped "")
set(without_fuzzer "")
if(NOT PRESETS)
    set(PRESETS release-float release-double sanitize-float sanitize-double sanitize-thread-double)
    set(clang_presets clang-float clang-double)
    find_program(clang clang++ NO_CACHE)
    if(clang)
        list(APPEND PRESETS ${clang_presets})
        buoyancy_has_fuzzer("${clang}" has_fuzzer)
        if(has_fuzzer)
            list(APPEND PRESETS fuzz-double)
        else()
            set(without_fuzzer fuzz-double)
        endif()
    else()
        set(skipped ${clang_presets} fuzz-double)
    endif()
endif()

# Runs one step of a preset in the source directory, showing its output, and sets status and output.
macro(run_step what)
    message(STATUS "${preset}: ${what}")
    execute_process(
        COMMAND ${ARGN}
        WORKING_DIRECTORY "${source_dir}"
        RESULT_VARIABLE status
        OUTPUT_VARIABLE output
        ECHO_OUTPUT_VARIABLE)
endmacro()

set(summary "")
set(failures "")
set(total_passed 0)
set(total_failed 0)
foreach(preset IN LISTS PRESETS)
    run_step(configure
        "${CMAKE_COMMAND}" --preset ${preset} -DBULLET_BUOYANCY_FETCH_DEPENDENCIES=${FETCH})
    if(status EQUAL 0)
        run_step(build "${CMAKE_COMMAND}" --build --preset ${preset} --parallel ${JOBS})
    endif()
    if(NOT status EQUAL 0)
        list(APPEND failures ${preset})
        list(APPEND summary "${preset}: not built")
        continue()
    endif()

    run_step(test "${CMAKE_CTEST_COMMAND}" --preset ${preset} --output-on-failure --parallel ${JOBS})
    if(output MATCHES "tests passed, ([0-9]+) tests failed out of ([0-9]+)")
        set(failed ${CMAKE_MATCH_1})
        math(EXPR passed "${CMAKE_MATCH_2} - ${failed}")
        math(EXPR total_passed "${total_passed} + ${passed}")
        math(EXPR total_failed "${total_failed} + ${failed}")
        list(APPEND summary "${preset}: ${passed} passed, ${failed} failed")
    else()
        list(APPEND summary "${preset}: no tests")
    endif()
    if(NOT status EQUAL 0)
        list(APPEND failures ${preset})
    endif()
endforeach()

foreach(preset IN LISTS skipped)
    list(APPEND summary "${preset}: skipped, because clang++ is not installed")
endforeach()
foreach(preset IN LISTS without_fuzzer)
    list(APPEND summary "${preset}: skipped, because clang++ comes without libFuzzer")
endforeach()
# An error reported this way makes the exit status a failure, and leaves the last word to the sum.
if(failures)
    list(JOIN failures ", " failures)
    message(SEND_ERROR "Failed: ${failures}")
endif()
list(JOIN summary "\n  " summary)
message(NOTICE "\n  ${summary}\n\ntests: ${total_passed} passed, ${total_failed} failed")
