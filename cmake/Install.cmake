# Float and double may share a prefix, when they are of one version: their libraries, targets and pkg-config
# modules have names of their own, and all else is the same.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/bullet_buoyancy")

set_target_properties(bullet_buoyancy PROPERTIES
    BULLET_BUOYANCY_PRECISION ${BUOYANCY_PRECISION}
    EXPORT_PROPERTIES BULLET_BUOYANCY_PRECISION)
install(TARGETS bullet_buoyancy_core bullet_buoyancy
    EXPORT bullet_buoyancy
    INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT bullet_buoyancy
    NAMESPACE bullet_buoyancy::
    FILE bullet_buoyancy-${PROJECT_VERSION}-${BUOYANCY_PRECISION}Targets.cmake
    DESTINATION "${package_dir}")

install(DIRECTORY "${PROJECT_SOURCE_DIR}/bullet_buoyancy" "${PROJECT_BINARY_DIR}/include/bullet_buoyancy"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    FILES_MATCHING PATTERN "*.h" PATTERN "docs" EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_file(
    "${PROJECT_SOURCE_DIR}/cmake/bullet_buoyancyConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/bullet_buoyancyConfig.cmake"
    @ONLY)
# Before 1.0 a minor version may break what the one before it promised: see CHANGELOG.md.
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/bullet_buoyancyConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
install(
    FILES
        "${PROJECT_BINARY_DIR}/bullet_buoyancyConfig.cmake"
        "${PROJECT_BINARY_DIR}/bullet_buoyancyConfigVersion.cmake"
        "${PROJECT_SOURCE_DIR}/cmake/FindBulletPhysics.cmake"
    DESTINATION "${package_dir}")

include("${CMAKE_CURRENT_LIST_DIR}/PkgConfig.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/DebianPackage.cmake")
