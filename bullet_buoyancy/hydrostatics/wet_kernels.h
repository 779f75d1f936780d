#pragma once

#include <cstdint>

#include "bullet_buoyancy/core/instruction_set.h"
#include "bullet_buoyancy/hull/packs.h"
#include "bullet_buoyancy/hydrostatics/clip_kernels.h"

namespace bullet_buoyancy {

/// A quadratic about a centre, for each triangle of a pack: see `Quadratic`.
struct QuadraticRows {
    PackRow<double> value, gradient[3];
    PackRow<double> bend[6];  ///< xx, xy, xz, yy, yz, zz
};

/// The water about each triangle of a pack: see `WaterExpansion`.
struct PackWater {
    PackRow<double> centre[3];  ///< m
    QuadraticRows depth, head;  ///< the latter only where it is another than the former
    PackRow<double> error[3];   ///< coefficients of the second, third and fourth power of the distance
    double typicalDistance;     ///< of the triangles from the centres, m: bounds are looser with another
};

/// What is the same for all packs.
struct PackSea {
    double up[3];
    double validity2;   ///< square of the distance from its centre within which an error holds, m^2
    double largest[3];  ///< triangles that are larger along an axis, m, are left
    double headError;   ///< but for those with an error of no more than this, m
    bool isHydrostatic;
};

/// Integrals over wholly wet triangles, each in sixteen parts, with d the depth, h the head, x the position
/// and n the outward normal.
struct HeadRows {
    PackRow<double> headNormal[3];   ///< of h n, m^3
    PackRow<double> headTorque[3];   ///< of h x cross n, m^4
    PackRow<double> depth;           ///< of d n_up, m^3
    PackRow<double> depthMoment[3];  ///< of d x n_up, m^4
    PackRow<double> depthSquared;    ///< of d^2 n_up, m^4
    PackRow<double> depthTimesHead;  ///< of d h n_up, m^4
    PackRow<double> error[3];        ///< upper bound of that of `headNormal`, m^3
    ShadowRows<double> shadow;       ///< if asked for
};

/// Adds the triangles of a pack that are wholly wet, whatever the error of the depth, with the water to
/// second order; lists those left over, which the surface may cut or which are too large. Returns how many
/// these are. Results are the same to the last bit for each instruction set.
using AddWetTriangles = int (*)(const TrianglePack<double>& pack, const PackWater& water, const PackSea& sea,
                                HeadRows& rows, std::uint8_t* left);

/// By WetRowsAsked.
struct WetKernels {
    AddWetTriangles addWet[2];
};

const WetKernels& wetKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
