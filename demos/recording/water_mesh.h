#pragma once

#include "recording/film.h"

namespace bullet_buoyancy::recording {

/// The triangles between the nodes of a film's surface, upward.
std::vector<Triangle> waterTriangles();

/// A node of a surface in the film's axes.
Vec3 waterVertex(const Film& film, const FilmedSurface& surface, int node);

/// Of the surface upward, so long that it rises by 1: those of a sum of surfaces add up.
Vec3 waterNormal(const FilmedSurface& surface, int node);

bool isFlat(const FilmedSurface& surface);

}  // namespace bullet_buoyancy::recording
