#pragma once

#include <string>

namespace bullet_buoyancy::scenes {

/// The first lines of a script that draws into a .png or .svg file, white, in a sans-serif font of `points`.
std::string gnuplotOutput(const std::string& file, int width, int height, int points);

/// Has the program gnuplot draw `file`. False, with a message to standard error that begins with the name of
/// the `demo`, where gnuplot is not installed or fails.
bool runGnuplot(const std::string& script, const std::string& demo, const std::string& file);

}  // namespace bullet_buoyancy::scenes
