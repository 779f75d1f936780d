# Builds and runs the demo, after installing what is missing:
#
#   cmake [-DFETCH=ON] -P cmake/demo.cmake
#
#   -DFETCH=ON   dependencies from source, not from packages

cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake")
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)

buoyancy_provide_dependencies(gnuplot-nox libassimp-dev libtinygltf-dev povray)

cmake_host_system_information(RESULT jobs QUERY NUMBER_OF_LOGICAL_CORES)

# A warning of a compiler newer than this release is no reason to go without the demo.
execute_process(
    COMMAND "${CMAKE_COMMAND}" --preset release-double --compile-no-warning-as-error
        -DBULLET_BUOYANCY_FETCH_DEPENDENCIES=${FETCH}
    WORKING_DIRECTORY "${source_dir}"
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(
    COMMAND "${CMAKE_COMMAND}" --build --preset release-double --target floating_cube --parallel ${jobs}
    WORKING_DIRECTORY "${source_dir}"
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(
    COMMAND "${source_dir}/build/release-double/demos/floating_cube"
    COMMAND_ERROR_IS_FATAL ANY)
