#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// Volume that lies inside both of two closed outward meshes, m^3: midpoint rule over 64 by 64 columns
/// through the part of space that both bounding boxes cover, exact along each column. An estimate to about 1
/// % of that space.
double overlapVolume(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace bullet_buoyancy
