# Packs the build as a Debian package, checks what it says of itself, and unpacks it.

cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${ROOT}" "${ROOT}-packed")
execute_process(
    COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB -C "${CONFIG}" -B "${ROOT}-packed" --config "${BUILD_DIR}/CPackConfig.cmake"
    COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package "${ROOT}-packed/libbullet-buoyancy-dev_*.deb")

function(expect field pattern)
    execute_process(
        COMMAND "${DPKG_DEB}" --field "${package}" ${field}
        OUTPUT_VARIABLE value
        OUTPUT_STRIP_TRAILING_WHITESPACE
        COMMAND_ERROR_IS_FATAL ANY)
    if(NOT value MATCHES "${pattern}")
        message(FATAL_ERROR "${package} has \"${value}\" for its ${field}, not ${pattern}")
    endif()
endfunction()
expect(Package "^libbullet-buoyancy-dev$")
expect(Section "^libdevel$")
expect(Maintainer "<.+@.+>")
expect(Depends "libbullet-dev")
expect(Depends "libeigen3-dev")

execute_process(COMMAND "${DPKG_DEB}" --extract "${package}" "${ROOT}" COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS "${ROOT}/usr/share/doc/libbullet-buoyancy-dev/copyright")
    message(FATAL_ERROR "${package} has no copyright file")
endif()
