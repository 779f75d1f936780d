#pragma once

#include <optional>
#include <string>

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy::demo {

/// Whether the program was built with the library assimp, which reads the files.
bool canReadMeshes();

/// All triangles of an OBJ, STL or other file that assimp knows, in its own axes and units. None, with a
/// message to standard error, if that fails.
std::optional<TriangleMesh> readMesh(const std::string& file);

}  // namespace bullet_buoyancy::demo
