#pragma once

#include "recording/world_film.h"
#include "scenes/flotsam.h"

namespace bullet_buoyancy::recording {

/// What a body of the scene is seen as.
Cast castOf(const scenes::FlotsamScene& scene, const btRigidBody& body);

/// The scene as it is now.
WorldView viewOf(const scenes::FlotsamScene& scene);

}  // namespace bullet_buoyancy::recording
