#pragma once

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy::recording {

/// What a body seems to be made of.
enum class Look { wood, paleWood, darkWood, orange, red, yellow, blue, white, steel, stone, sand };

struct Material {
    const char* name;
    Vec3 colour;       ///< linear, 0 to 1
    double roughness;  ///< 0 to 1, as glTF has it
    double metallic;   ///< 0 or 1
};

const Material& materialOf(Look look);

/// All looks, in the order of the enumeration.
inline constexpr int lookCount = int(Look::sand) + 1;

}  // namespace bullet_buoyancy::recording
