#pragma once

#include "bullet_buoyancy/hydrostatics/reference_patches.h"
#include "bullet_buoyancy/hydrostatics/reference_water.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// A corner of a cell and how deep it lies, m.
struct CellCorner {
    Vec2 parameters;
    double depth;
};

using CellCorners = std::array<CellCorner, 3>;

/// What the wet part of a cell, a triangle of a patch's parameters, adds to the integrals.
struct CellIntegral {
    WetIntegrals value;
    WetIntegrals
        rougher;  ///< the same by a rule of lower order: their difference bounds the error of `value`

    /// Where the waterline may run otherwise than was found: on that much of the surface, m^2, the depth is
    /// wrong by no more than `depthInDoubt`, m. Zero where the bounds of the water's slope and curvature tell
    /// that it does not.
    double areaInDoubt = 0;
    double depthInDoubt = 0;
};

/// By Gauss quadrature along rays from one corner to the opposite side. Where the corners are wet and dry,
/// that corner is the one which differs from the others, and each ray is cut where it crosses the water's
/// surface: the curved waterline is met exactly, so that the error falls with the order of the rule there
/// too.
CellIntegral integrateCell(const SurfacePatch& patch, const CellCorners& corners, WaterAroundBody& water);

}  // namespace bullet_buoyancy
