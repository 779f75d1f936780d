#pragma once

#include <string>
#include <vector>

#include "speed_vs_error/study.h"

namespace bullet_buoyancy::demo {

/// Draws time against the force's median error, for four of the hulls and waters, into a .png or .svg file,
/// by the program gnuplot. False, with a message to standard error, where that is not installed or fails.
bool plot(const std::vector<SpeedRow>& rows, const std::string& file);

}  // namespace bullet_buoyancy::demo
