#pragma once

#include <string>

#include "recording/film.h"

namespace bullet_buoyancy::recording {

/// Draws one frame of the film into a .png file, by the program POV-Ray: the bodies in a block cut out of the
/// sea, seen from slightly above. Empty if all is well, else what is wrong.
std::string drawPicture(const Film& film, std::size_t frame, const std::string& file);

}  // namespace bullet_buoyancy::recording
