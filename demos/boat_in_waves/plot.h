#pragma once

#include <string>

#include "boat_in_waves/responses.h"

namespace bullet_buoyancy::demo {

/// What is to be seen of a voyage.
struct Picture {
    const scenes::Boat& boat;
    scenes::Sea& sea;  ///< is shown at other times
    const scenes::Voyage& voyage;
    const Responses& responses;
};

/// Draws the boat in the highest waves, its motions about that time and the spectra into a .png or .svg file,
/// by the program gnuplot. False, with a message to standard error, where that is not installed or fails.
bool plot(const Picture& picture, const std::string& file);

}  // namespace bullet_buoyancy::demo
