#pragma once

#include <string>
#include <vector>

#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy::test {

/// An axis-aligned box of given full sizes about `centre`: 12 triangles.
TriangleMesh boxMesh(const Vec3& size, const Vec3& centre = Vec3::Zero());

/// A ring of square section: not convex, genus 1. Inner and outer radius, half height.
TriangleMesh ringMesh(double inner, double outer, double halfHeight, int segments);

/// The polyhedron between the lines of a Wigley hull, y = +-B/2 (1 - (2x/L)^2)(1 - (z/T)^2), closed by a deck
/// at z = 0.
TriangleMesh wigleyMesh(double length, double beam, double draft, int stations, int waterlines);

/// Makes a hull that must be accepted.
std::shared_ptr<const Hull> hullOf(std::vector<HullPart> parts);
std::shared_ptr<const Hull> hullOf(TriangleMesh mesh);

struct NamedHull {
    std::string name;
    std::shared_ptr<const Hull> hull;
};

/// Closed polyhedra of about 1 m: convex, concave, with a hole, of several parts, with a cavity.
std::vector<NamedHull> polyhedra();

/// Solids with curved surfaces of about 1 m: sphere, capsule, tapered capsule, cylinder, disc, rod, cone.
std::vector<NamedHull> smoothSolids();

}  // namespace bullet_buoyancy::test
