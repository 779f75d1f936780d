#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy::scenes {

struct NamedHull {
    std::string name;
    std::shared_ptr<const Hull> hull;
};

/// A box of the size (m) about the origin.
TriangleMesh boxMesh(const Vec3& size);

/// An ellipsoid of about a metre with low bumps: 20 * 4^levels triangles.
TriangleMesh bumpyMesh(int levels);

/// Convex, of random points (fixed seed) on an ellipsoid of about a metre, each of which is a vertex.
TriangleMesh pointsHull(int points);

/// A mesh for those who know no round solids: spheres of 320 triangles, solids of revolution of some hundred.
TriangleMesh asMesh(const Hull& hull);

/// Hulls of about a metre, of every kind and from 12 to 81,920 triangles, and a boat of 10 m.
std::vector<NamedHull> hullsOfAllKinds();

}  // namespace bullet_buoyancy::scenes
