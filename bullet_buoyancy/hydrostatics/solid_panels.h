#pragma once

#include "bullet_buoyancy/hull/solid_of_revolution.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// The solid of revolution whose pieces someone else keeps: nothing is allocated for one.
struct RoundBody {
    Vec3 origin, axis;
    const ProfilePiece *begin, *end;

    explicit RoundBody(const SolidOfRevolution& solid)
        : origin(solid.origin),
          axis(solid.axis),
          begin(solid.profile.data()),
          end(solid.profile.data() + solid.profile.size()) {}

    /// A sphere's whole profile is one piece, `pieceOf` it.
    RoundBody(const Sphere& sphere, const ProfilePiece& piece)
        : origin(sphere.centre), axis(Vec3::UnitX()), begin(&piece), end(&piece + 1) {}
};

inline ProfilePiece pieceOf(const Sphere& sphere) {
    return {-sphere.radius, sphere.radius, sphere.radius * sphere.radius, 0, -1};
}

/// Adds what waves do to a solid by Gauss quadrature over curved panels: whole ones under water, and lines
/// across those that the surface cuts, each up to where it crosses the surface. Panels are quartered where
/// they reach over cells of the patch, and where the surface touches them, until errors of the head are about
/// `headError` (m).
void addPanels(const RoundBody& body, const WaterPatch& water, double headError,
               const HydrostaticQuery& query, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
