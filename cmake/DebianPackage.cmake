# What `cpack -G DEB` packs: libbullet-buoyancy-dev, with the libraries of this build. package.cmake puts both
# precisions into one package.

if(NOT PROJECT_IS_TOP_LEVEL)
    return()
endif()

set(deb_name libbullet-buoyancy-dev)

set(CPACK_PACKAGE_NAME bullet-buoyancy)
set(CPACK_PACKAGE_VENDOR "The bullet_buoyancy authors")
set(CPACK_PACKAGE_CONTACT "The bullet_buoyancy authors <authors@bullet-buoyancy.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION} (development files)")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_PACKAGE_NAME ${deb_name})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libbullet-dev, libeigen3-dev")
string(CONCAT CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Adds one action to a world of Bullet Physics, and crates, hulls, barrels and spars float as they do in nature, "
    "in flat water and in waves.\n"
    "\n"
    "Has headers, libraries for Bullet in the precisions they were built for, and files for CMake and pkg-config.")

# Debian looks for the licence under this name; nobody else does.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${deb_name}"
    RENAME copyright
    COMPONENT debian
    EXCLUDE_FROM_ALL)
set(CPACK_INSTALL_CMAKE_PROJECTS
    "${PROJECT_BINARY_DIR}" ${PROJECT_NAME} ALL /
    "${PROJECT_BINARY_DIR}" ${PROJECT_NAME} debian /)

include(CPack)
