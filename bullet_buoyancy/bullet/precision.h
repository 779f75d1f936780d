#pragma once

#include "bullet_buoyancy/config.h"

// btScalar is part of this library's interface: whoever includes it must see the btScalar it was compiled
// with. Linking the CMake target bullet_buoyancy::bullet_buoyancy is enough for that.
// clang-format off
#if BULLET_BUOYANCY_DOUBLE_PRECISION && !defined(BT_USE_DOUBLE_PRECISION)
#error "This bullet_buoyancy is built for double-precision Bullet. Define BT_USE_DOUBLE_PRECISION and link the double-precision Bullet, or build bullet_buoyancy with -DBULLET_BUOYANCY_DOUBLE_PRECISION=OFF."
#elif !BULLET_BUOYANCY_DOUBLE_PRECISION && defined(BT_USE_DOUBLE_PRECISION)
#error "This bullet_buoyancy is built for float-precision Bullet. Drop BT_USE_DOUBLE_PRECISION and link the float-precision Bullet, or build bullet_buoyancy with -DBULLET_BUOYANCY_DOUBLE_PRECISION=ON."
#endif
// clang-format on
