# Provides every dependency from source, under the same names as its package would. Each download can be
# replaced by a local tree with FETCHCONTENT_SOURCE_DIR_<BULLET|EIGEN3|GTEST|CLI11|TINYGLTF>.

include(FetchContent)

FetchContent_Declare(Bullet
    URL https://github.com/bulletphysics/bullet3/archive/refs/tags/3.25.tar.gz
    URL_HASH SHA256=c45afb6399e3f68036ddb641c6bf6f552bf332d5ab6be62f7e6c54eda05ceb77
    DOWNLOAD_EXTRACT_TIMESTAMP ON)

# Eigen is headers only: an absent SOURCE_SUBDIR keeps its own build, with all its tests, out of ours.
FetchContent_Declare(Eigen3
    URL https://gitlab.com/libeigen/eigen/-/archive/3.4.0/eigen-3.4.0.tar.gz
    URL_HASH SHA256=8586084f71f9bde545ee7fa6d00288b264a2b7ac3607b974e54d13e7162c1c72
    DOWNLOAD_EXTRACT_TIMESTAMP ON
    SOURCE_SUBDIR no-build)

FetchContent_Declare(GTest
    URL https://github.com/google/googletest/archive/refs/tags/v1.14.0.tar.gz
    URL_HASH SHA256=8ad598c73ad796e0d8280b082cebd82a630d73e73cd3c70057938a6501bba5d7
    DOWNLOAD_EXTRACT_TIMESTAMP ON
    OVERRIDE_FIND_PACKAGE
    SYSTEM)

FetchContent_Declare(CLI11
    URL https://github.com/CLIUtils/CLI11/archive/refs/tags/v2.4.2.tar.gz
    URL_HASH SHA256=f2d893a65c3b1324c50d4e682c0cdc021dd0477ae2c048544f39eed6654b699a
    DOWNLOAD_EXTRACT_TIMESTAMP ON
    OVERRIDE_FIND_PACKAGE
    SYSTEM)

FetchContent_Declare(TinyGLTF
    GIT_REPOSITORY https://github.com/syoyo/tinygltf.git
    GIT_TAG fda7422022ff058b1b7b501d373a97b1cc377bfd  # 2.9.3
    OVERRIDE_FIND_PACKAGE
    SYSTEM)

# The dependencies ask for a CMake so old that, left alone, their options would ignore the variables set here,
# MSVC would give them another runtime library than ours, and a recent CMake would refuse Bullet altogether.
set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)
set(CMAKE_POLICY_DEFAULT_CMP0091 NEW)
set(CMAKE_POLICY_VERSION_MINIMUM 3.5)

set(BUILD_GMOCK OFF)
set(INSTALL_GTEST OFF)
set(CLI11_INSTALL OFF)
set(TINYGLTF_BUILD_LOADER_EXAMPLE OFF)
set(TINYGLTF_INSTALL OFF)

set(USE_DOUBLE_PRECISION ${BULLET_BUOYANCY_DOUBLE_PRECISION})
set(USE_GRAPHICAL_BENCHMARK OFF)
set(CMAKE_DISABLE_FIND_PACKAGE_OpenGL ON)
set(USE_MSVC_DISABLE_RTTI OFF)
foreach(part IN ITEMS BULLET3 BULLET2_DEMOS CPU_DEMOS OPENGL3_DEMOS EXTRAS UNIT_TESTS ENET CLSOCKET EGL)
    set(BUILD_${part} OFF)
endforeach()

FetchContent_MakeAvailable(Bullet Eigen3)
# Only what we link is built, and nothing of Bullet is installed.
set_property(DIRECTORY "${bullet_SOURCE_DIR}" PROPERTY EXCLUDE_FROM_ALL ON)

add_library(bullet_buoyancy::bullet_physics INTERFACE IMPORTED)
target_link_libraries(bullet_buoyancy::bullet_physics INTERFACE BulletDynamics BulletCollision LinearMath)
target_include_directories(bullet_buoyancy::bullet_physics SYSTEM INTERFACE "${bullet_SOURCE_DIR}/src")
if(BULLET_BUOYANCY_DOUBLE_PRECISION)
    target_compile_definitions(bullet_buoyancy::bullet_physics INTERFACE BT_USE_DOUBLE_PRECISION)
endif()
if(BULLET2_MULTITHREADING)  # whoever sees Bullet's headers must see them as Bullet was built
    target_compile_definitions(bullet_buoyancy::bullet_physics INTERFACE BT_THREADSAFE=1)
endif()

add_library(Eigen3::Eigen INTERFACE IMPORTED)
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE "${eigen3_SOURCE_DIR}")
