#pragma once

#include <string>
#include <vector>

#include "scenes/floating_cube.h"
#include "scenes/floating_log.h"

namespace bullet_buoyancy::demo {

/// Draws the logs as they float, their tilts over the analytic curve, and the fall of the cube into a .png or
/// .svg file, by the program gnuplot. False, with a message to standard error, where that is not installed or
/// fails.
bool plot(const scenes::CubeResult& cube, const std::vector<scenes::LogResult>& logs,
          const std::string& file);

}  // namespace bullet_buoyancy::demo
