#pragma once

#include <BulletCollision/CollisionShapes/btStridingMeshInterface.h>

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// Appends one part of a mesh as the user's arrays have it, each vertex times `scaling`; an index that is out
/// of range stays so.
void readStridingMesh(const btStridingMeshInterface& source, int part, const Vec3& scaling,
                      TriangleMesh& mesh);

}  // namespace bullet_buoyancy
