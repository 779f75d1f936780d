# Writes and installs the pkg-config module of this precision, bullet_buoyancy or bullet_buoyancy-float64. It
# finds its prefix from where it lies.

set(pc_name bullet_buoyancy${BUOYANCY_SUFFIX})
set(pc_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

# The directories under the prefix, unless they were given as absolute ones.
set(pc_libdir "\${prefix}")
cmake_path(APPEND pc_libdir "${CMAKE_INSTALL_LIBDIR}")
set(pc_includedir "\${prefix}")
cmake_path(APPEND pc_includedir "${CMAKE_INSTALL_INCLUDEDIR}")
set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
if(NOT IS_ABSOLUTE "${pc_dir}")
    file(RELATIVE_PATH up "/prefix/${pc_dir}" "/prefix")
    string(REGEX REPLACE "/$" "" pc_prefix "\${pcfiledir}/${up}")
endif()

set(pc_define -DBULLET_BUOYANCY_DOUBLE_PRECISION=0)
if(BULLET_BUOYANCY_DOUBLE_PRECISION)
    set(pc_define "-DBULLET_BUOYANCY_DOUBLE_PRECISION=1 -DBT_USE_DOUBLE_PRECISION")
endif()

# Bullet by its own module, where that is of the Bullet that we link.
set(pc_requires eigen3)
set(pc_bullet_cflags "")
set(pc_bullet_libs "")
if(BulletPhysics_PC_MODULE)
    string(APPEND pc_requires " ${BulletPhysics_PC_MODULE}")
else()
    set(pc_bullet_cflags "\"-I${BulletPhysics_INCLUDE_DIR}\"")
    foreach(library IN ITEMS BulletDynamics BulletCollision LinearMath)
        string(APPEND pc_bullet_libs " \"${BulletPhysics_${BUOYANCY_PRECISION}_${library}}\"")
    endforeach()
endif()

configure_file("${PROJECT_SOURCE_DIR}/cmake/bullet_buoyancy.pc.in" "${PROJECT_BINARY_DIR}/${pc_name}.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/${pc_name}.pc" DESTINATION "${pc_dir}")
