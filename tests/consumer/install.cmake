# Installs the build into a prefix which is then moved, so that whatever still names the old place fails.

cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}-before-moving")
execute_process(
    COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${PREFIX}-before-moving"
    COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${PREFIX}-before-moving" "${PREFIX}")
