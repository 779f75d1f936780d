#pragma once

#include "bullet_buoyancy/hydrostatics/reference_patches.h"
#include "bullet_buoyancy/hydrostatics/reference_water.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// A point of a patch and how deep it lies, m.
struct CellPoint {
    Vec2 parameters;
    double depth;
};

/// A triangle of a patch's parameters.
struct Cell {
    std::array<CellPoint, 3> corners;
    std::array<CellPoint, 3> middles;  ///< of the sides from corner 0 to 1, 1 to 2, 2 to 0
};

Cell makeCell(const SurfacePatch& patch, const std::array<CellPoint, 3>& corners, WaterAroundBody& water);

std::array<Cell, 4> quarters(const SurfacePatch& patch, const Cell& cell, WaterAroundBody& water);

/// Where the waterline may run otherwise than a cell's corners and the rays of `integrateWetPart` tell: on so
/// much of the surface, m^2, the depth is wrong by so much, m.
struct CellDoubt {
    double area = 0, depth = 0;
    bool isDry = false;  ///< no point of the cell is wet
};

/// From how far the depth may bend away from linear: twice what its second differences along the sides show,
/// but not less than an eighth of what the bounds of the water's and the surface's curvature allow (waves too
/// short for the cell may hide from six points), and no more than they allow.
CellDoubt doubtOf(const SurfacePatch& patch, const Cell& cell, const WaterAroundBody& water);

/// Rays in a cell, and points on a ray.
enum class CellRule { three, five, eight };

/// What the wet part of a cell adds to the integrals, by Gauss quadrature along rays from one corner to the
/// opposite side. Where some corners are wet and some dry, that corner is the one which differs from the
/// others, and each ray is cut where it crosses the water's surface: the curved waterline is met exactly, so
/// that the error falls with the order of the rule there too.
WetIntegrals integrateWetPart(const SurfacePatch& patch, const Cell& cell, CellRule rule,
                              WaterAroundBody& water);

}  // namespace bullet_buoyancy
