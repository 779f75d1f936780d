# The port for vcpkg must name the version of the project.
#
#   cmake -D VERSION=<version> -D PORT=<vcpkg.json> -P version_test.cmake

file(READ "${PORT}" port)
string(JSON version GET "${port}" version-semver)
if(NOT version STREQUAL VERSION)
    message(FATAL_ERROR "${PORT} is of ${version}, the project of ${VERSION}")
endif()
