# Builds a Debian package of the library in both precisions, build/package/libbullet-buoyancy-dev_*.deb, after
# installing what is missing:
#
#   cmake -P cmake/package.cmake

cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake")
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)
set(package_dir "${source_dir}/build/package")

buoyancy_provide_dependencies(pkg-config)

cmake_host_system_information(RESULT jobs QUERY NUMBER_OF_LOGICAL_CORES)

set(projects "")
foreach(precision IN ITEMS float double)
    set(build_dir "${package_dir}/${precision}")
    string(COMPARE EQUAL ${precision} double is_double)
    # Under the prefix that Debian's packages have, GNUInstallDirs chooses Debian's directories.
    execute_process(
        COMMAND "${CMAKE_COMMAND}" -S "${source_dir}" -B "${build_dir}" -G Ninja
            -DCMAKE_BUILD_TYPE=Release
            -DCMAKE_INSTALL_PREFIX=/usr
            -DBULLET_BUOYANCY_DOUBLE_PRECISION=${is_double}
            -DBULLET_BUOYANCY_BUILD_TESTS=OFF
            -DBULLET_BUOYANCY_BUILD_DEMOS=OFF
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(
        COMMAND "${CMAKE_COMMAND}" --build "${build_dir}" --parallel ${jobs}
        COMMAND_ERROR_IS_FATAL ANY)
    list(APPEND projects "${build_dir}" bullet_buoyancy ALL /)
endforeach()
list(APPEND projects "${build_dir}" bullet_buoyancy debian /)

execute_process(
    COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB -B "${package_dir}" --config "${build_dir}/CPackConfig.cmake"
        -D "CPACK_INSTALL_CMAKE_PROJECTS=${projects}"
    COMMAND_ERROR_IS_FATAL ANY)
