#pragma once

#include <limits>
#include <vector>

#include "bullet_buoyancy/water/wave_component.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// Side by side, in the order given, in water of a depth in m.
std::vector<WaveLanes> packWaves(const std::vector<WaveComponent>& components,
                                 double depth = std::numeric_limits<double>::infinity());

}  // namespace bullet_buoyancy
