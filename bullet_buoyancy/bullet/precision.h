#pragma once

// btScalar is part of this library's interface: whoever includes it must see the btScalar it was compiled
// with. Linking the CMake target bullet_buoyancy::bullet_buoyancy is enough for that, and
// pkg-config has the flags.
// clang-format off
#if !defined(BULLET_BUOYANCY_DOUBLE_PRECISION)
#error "Define BULLET_BUOYANCY_DOUBLE_PRECISION to 1 for a bullet_buoyancy that is built for double-precision Bullet, to 0 for float. The CMake target bullet_buoyancy::bullet_buoyancy and pkg-config do."
#elif BULLET_BUOYANCY_DOUBLE_PRECISION && !defined(BT_USE_DOUBLE_PRECISION)
#error "This bullet_buoyancy is built for double-precision Bullet. Define BT_USE_DOUBLE_PRECISION and link the double-precision Bullet, or build bullet_buoyancy with -DBULLET_BUOYANCY_DOUBLE_PRECISION=OFF."
#elif !BULLET_BUOYANCY_DOUBLE_PRECISION && defined(BT_USE_DOUBLE_PRECISION)
#error "This bullet_buoyancy is built for float-precision Bullet. Drop BT_USE_DOUBLE_PRECISION and link the float-precision Bullet, or build bullet_buoyancy with -DBULLET_BUOYANCY_DOUBLE_PRECISION=ON."
#endif
// clang-format on
