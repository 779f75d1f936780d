# What test.cmake and demo.cmake need before they can configure.

option(FETCH "Build the libraries from source, not from packages" OFF)

# buoyancy_provide_dependencies([<optional apt package>...])
#
# Installs what is missing where apt-get is at hand and may be used, and otherwise says what to install. An
# optional package is never worth stopping for.
function(buoyancy_provide_dependencies)
    set(missing "")
    find_program(compiler NAMES $ENV{CXX} c++ g++ clang++ cl NO_CACHE)
    if(NOT compiler)
        list(APPEND missing g++)
    endif()
    find_program(ninja NAMES ninja ninja-build NO_CACHE)
    if(NOT ninja)
        list(APPEND missing ninja-build)
    endif()

    find_program(apt_get apt-get NO_CACHE)
    if(NOT apt_get)
        buoyancy_explain_dependencies()
        return()
    endif()

    if(FETCH)
        set(libraries ca-certificates)
    else()
        set(libraries libbullet-dev libeigen3-dev libgtest-dev libcli11-dev)
    endif()
    buoyancy_missing_packages(missing_libraries ${libraries})
    buoyancy_missing_packages(missing_optional ${ARGN})
    list(APPEND missing ${missing_libraries})
    if(NOT missing AND NOT missing_optional)
        return()
    endif()

    buoyancy_find_root(may_install as_root)
    if(may_install)
        set(missing_required ${missing})
        list(APPEND missing ${missing_optional})
        list(JOIN missing " " names)
        message(STATUS "Installing ${names}")
        set(on_failure "")
        if(missing_required)
            set(on_failure COMMAND_ERROR_IS_FATAL ANY)
        endif()
        execute_process(COMMAND ${as_root} apt-get update ${on_failure})
        execute_process(
            COMMAND ${as_root} env DEBIAN_FRONTEND=noninteractive
                apt-get install --yes --no-install-recommends ${missing}
            ${on_failure})
    elseif(missing)
        buoyancy_explain_dependencies()
        list(JOIN missing " " missing)
        message(FATAL_ERROR "Missing here: ${missing}")
    endif()
endfunction()

function(buoyancy_missing_packages result)
    set(missing "")
    foreach(package IN LISTS ARGN)
        execute_process(
            COMMAND dpkg-query --show "--showformat=\${db:Status-Status}" ${package}
            OUTPUT_VARIABLE status
            ERROR_QUIET)
        if(NOT status STREQUAL "installed")
            list(APPEND missing ${package})
        endif()
    endforeach()
    set(${result} ${missing} PARENT_SCOPE)
endfunction()

# Whether commands can run as root without a password, and by which prefix.
function(buoyancy_find_root may_be_root prefix)
    set(${may_be_root} TRUE PARENT_SCOPE)
    set(${prefix} "" PARENT_SCOPE)
    execute_process(COMMAND id -u OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(user EQUAL 0)
        return()
    endif()
    find_program(sudo sudo NO_CACHE)
    if(sudo)
        execute_process(COMMAND "${sudo}" -n true RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
        if(failed EQUAL 0)
            set(${prefix} "${sudo}" -n PARENT_SCOPE)
            return()
        endif()
    endif()
    set(${may_be_root} FALSE PARENT_SCOPE)
endfunction()

function(buoyancy_explain_dependencies)
    message(NOTICE
"bullet_buoyancy needs a C++17 compiler, Ninja, Bullet, Eigen, and for tests and demos GoogleTest and CLI11:

  Debian, Ubuntu   sudo apt-get install g++ ninja-build libbullet-dev libeigen3-dev libgtest-dev libcli11-dev
  Fedora           sudo dnf install gcc-c++ ninja-build bullet-devel eigen3-devel gtest-devel cli11-devel
  Arch             sudo pacman -S --needed gcc ninja bullet eigen gtest cli11         (double precision: bullet-dp)
  macOS            brew install ninja bullet eigen googletest cli11
  vcpkg            vcpkg install bullet3 eigen3 gtest cli11   (double precision: bullet3[double-precision])

The demos draw by gnuplot and POV-Ray, write films by TinyGLTF and read hulls from files by assimp, where there are
(Debian: gnuplot-nox, povray, libtinygltf-dev, libassimp-dev).
Doxygen makes the API reference.

Where a Bullet of the wanted precision is not packaged, -DFETCH=ON builds all libraries from source.
")
endfunction()
