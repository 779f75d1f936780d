#pragma once

#include <string>

#include "recording/film.h"

namespace bullet_buoyancy::recording {

/// How far the water of a file may be from that of the film, m.
inline constexpr double waterTolerance = 1e-3;

/// Writes the film as a glTF 2.0 binary (.glb) with one animation: a node for each body, a mesh for each
/// shape, and the water as a mesh that is bent by morph targets. Units and axes are the film's. The file
/// appears when it is complete. Empty if all is well, else what is wrong.
std::string writeGltf(const Film& film, const std::string& file);

}  // namespace bullet_buoyancy::recording
