#pragma once

#include <limits>
#include <vector>

#include "bullet_buoyancy/water/wave_component.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// `depth` of the water in m.
std::vector<WaveLanes> packWaves(const std::vector<WaveComponent>& components,
                                 double depth = std::numeric_limits<double>::infinity());

}  // namespace bullet_buoyancy
