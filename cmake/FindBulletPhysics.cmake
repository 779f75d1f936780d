# Finds Bullet in one precision, named by the only component, and makes sure of that precision by linking:
#
#   find_package(BulletPhysics REQUIRED COMPONENTS float)   # or double
#
# Defines the imported target bullet_buoyancy::bullet_physics, and BulletPhysics_PC_MODULE: the pkg-config module
# of that Bullet, if it has one. Neither CMake's FindBullet nor Bullet's own
# BulletConfig.cmake would do: float and double look the same to them.

include(FindPackageHandleStandardArgs)

set(BulletPhysics_precision "${BulletPhysics_FIND_COMPONENTS}")
if(BulletPhysics_precision STREQUAL "float")
    set(BulletPhysics_other_precision double)
    set(BulletPhysics_other_option BULLET_BUOYANCY_DOUBLE_PRECISION=ON)
    set(BulletPhysics_suffix "")
elseif(BulletPhysics_precision STREQUAL "double")
    set(BulletPhysics_other_precision float)
    set(BulletPhysics_other_option BULLET_BUOYANCY_DOUBLE_PRECISION=OFF)
    set(BulletPhysics_suffix -float64)
else()
    message(FATAL_ERROR
        "find_package(BulletPhysics) takes one component, float or double, not \"${BulletPhysics_precision}\".")
endif()

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_search_module(BulletPhysics_${BulletPhysics_precision}_PC QUIET bullet${BulletPhysics_suffix} bullet)
endif()

find_path(BulletPhysics_INCLUDE_DIR btBulletDynamicsCommon.h
    HINTS ${BulletPhysics_${BulletPhysics_precision}_PC_INCLUDE_DIRS}
    PATH_SUFFIXES bullet)
mark_as_advanced(BulletPhysics_INCLUDE_DIR)

# In the order a linker needs for static libraries. Debian gives the double ones a suffix, Homebrew a directory,
# and a Bullet built by hand neither: within one directory the suffix goes first, among directories the nearest.
set(BulletPhysics_LIBRARIES "")
set(BulletPhysics_library_variables "")
foreach(library IN ITEMS BulletDynamics BulletCollision LinearMath)
    set(variable BulletPhysics_${BulletPhysics_precision}_${library})
    find_library(${variable}
        NAMES ${library}${BulletPhysics_suffix} ${library} NAMES_PER_DIR
        HINTS ${BulletPhysics_${BulletPhysics_precision}_PC_LIBRARY_DIRS}
        PATH_SUFFIXES bullet/${BulletPhysics_precision})
    mark_as_advanced(${variable})
    list(APPEND BulletPhysics_library_variables ${variable} ${variable}_DEBUG)

    # MSVC links no release library into a debug program. Bullet names its debug libraries so.
    find_library(${variable}_DEBUG NAMES ${library}${BulletPhysics_suffix}_Debug ${library}_Debug NAMES_PER_DIR
        PATH_SUFFIXES bullet/${BulletPhysics_precision})
    mark_as_advanced(${variable}_DEBUG)
    if(${variable}_DEBUG)
        if(NOT ${variable})
            set(${variable} "${${variable}_DEBUG}")
        endif()
        list(APPEND BulletPhysics_LIBRARIES optimized "${${variable}}" debug "${${variable}_DEBUG}")
    else()
        list(APPEND BulletPhysics_LIBRARIES "${${variable}}")
    endif()
endforeach()

set(BulletPhysics_PC_MODULE "")
if(BulletPhysics_${BulletPhysics_precision}_PC_FOUND)
    cmake_path(GET BulletPhysics_${BulletPhysics_precision}_BulletDynamics PARENT_PATH BulletPhysics_directory)
    cmake_path(SET BulletPhysics_module_directory NORMALIZE "${BulletPhysics_${BulletPhysics_precision}_PC_LIBDIR}")
    cmake_path(COMPARE "${BulletPhysics_directory}" EQUAL "${BulletPhysics_module_directory}"
        BulletPhysics_is_of_module)
    if(BulletPhysics_is_of_module)
        set(BulletPhysics_PC_MODULE ${BulletPhysics_${BulletPhysics_precision}_PC_MODULE_NAME})
    endif()
endif()

# Links a call whose mangled name spells btScalar.
function(BulletPhysics_try_link result precision)
    set(definitions "")
    if(precision STREQUAL "double")
        set(definitions -DBT_USE_DOUBLE_PRECISION)
    endif()
    try_compile(links
        SOURCE_FROM_CONTENT bullet_precision.cpp [[
            #include <btBulletDynamicsCommon.h>
            int main(int argc, char** argv)
            {
                if (argc > 1) reinterpret_cast<btRigidBody*>(argv)->setDamping(btScalar(0), btScalar(0));
            }
        ]]
        CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${BulletPhysics_INCLUDE_DIR}"
        COMPILE_DEFINITIONS ${definitions}
        LINK_LIBRARIES ${BulletPhysics_LIBRARIES}
        NO_CACHE)
    set(${result} ${links} PARENT_SCOPE)
endfunction()

set(BulletPhysics_has_precision FALSE)
set(BulletPhysics_failure "")
if(NOT BulletPhysics_INCLUDE_DIR OR BulletPhysics_LIBRARIES MATCHES "NOTFOUND")
    set(BulletPhysics_failure "No Bullet Physics was found.")
elseif("${BulletPhysics_LIBRARIES}" STREQUAL "${BulletPhysics_${BulletPhysics_precision}_LINKED}")
    set(BulletPhysics_has_precision TRUE)
else()
    BulletPhysics_try_link(BulletPhysics_has_precision ${BulletPhysics_precision})
    if(BulletPhysics_has_precision)
        set(BulletPhysics_${BulletPhysics_precision}_LINKED "${BulletPhysics_LIBRARIES}" CACHE INTERNAL
            "The libraries known to link in ${BulletPhysics_precision} precision")
    else()
        set(BulletPhysics_failure "${BulletPhysics_${BulletPhysics_precision}_BulletDynamics}")
        BulletPhysics_try_link(BulletPhysics_has_other_precision ${BulletPhysics_other_precision})
        if(BulletPhysics_has_other_precision)
            string(APPEND BulletPhysics_failure " is a Bullet in ${BulletPhysics_other_precision} precision.")
        else()
            string(APPEND BulletPhysics_failure " is there, but a program which calls it does not link.")
        endif()
        # The next run shall look again, perhaps with another CMAKE_PREFIX_PATH.
        foreach(variable IN LISTS BulletPhysics_library_variables ITEMS BulletPhysics_INCLUDE_DIR)
            unset(${variable} CACHE)
        endforeach()
    endif()
endif()

find_package_handle_standard_args(BulletPhysics
    REQUIRED_VARS BulletPhysics_LIBRARIES BulletPhysics_has_precision
    REASON_FAILURE_MESSAGE "${BulletPhysics_failure}
    Wanted: Bullet in ${BulletPhysics_precision} precision. Any of these helps:
      - install it (Debian and Ubuntu: libbullet-dev, which holds both precisions),
      - name the prefix of a ${BulletPhysics_precision} Bullet in CMAKE_PREFIX_PATH,
      - build bullet_buoyancy with BULLET_BUOYANCY_FETCH_DEPENDENCIES=ON, which builds its own Bullet,
      - build bullet_buoyancy for a ${BulletPhysics_other_precision} Bullet, with ${BulletPhysics_other_option}.
")

if(BulletPhysics_FOUND AND NOT TARGET bullet_buoyancy::bullet_physics)
    add_library(bullet_buoyancy::bullet_physics INTERFACE IMPORTED)
    target_link_libraries(bullet_buoyancy::bullet_physics INTERFACE ${BulletPhysics_LIBRARIES})
    target_include_directories(bullet_buoyancy::bullet_physics SYSTEM INTERFACE "${BulletPhysics_INCLUDE_DIR}")
    if(BulletPhysics_precision STREQUAL "double")
        target_compile_definitions(bullet_buoyancy::bullet_physics INTERFACE BT_USE_DOUBLE_PRECISION)
    endif()
endif()
