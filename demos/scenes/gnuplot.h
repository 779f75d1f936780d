#pragma once

#include <string>

namespace bullet_buoyancy::scenes {

/// For gnuplot's single quotes.
std::string quotedForGnuplot(const std::string& text);

bool gnuplotIsInstalled();

}  // namespace bullet_buoyancy::scenes
