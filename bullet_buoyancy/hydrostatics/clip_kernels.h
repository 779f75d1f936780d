#pragma once

#include "bullet_buoyancy/core/instruction_set.h"
#include "bullet_buoyancy/hull/packs.h"

namespace bullet_buoyancy {

/// The water's surface as a packed mesh sees it: depth = depthOfOrigin - up . x, m.
struct PackPlane {
    double up[3];
    double depthOfOrigin;
};

/// Integrals over the wet surface, each in sixteen parts, with d the depth, x the position and n_up the
/// upward part of the outward normal.
template <typename Real>
struct PressureRows {
    PackRow<Real> depth;           ///< of d n_up, m^3
    PackRow<Real> depthMoment[3];  ///< of d x n_up, m^4
};

template <typename Real>
struct ShadowRows {
    PackRow<Real> shadow;             ///< of n_up, m^2
    PackRow<Real> shadowMoment[3];    ///< of x n_up, m^3
    PackRow<Real> shadowMoments2[6];  ///< of x_i x_j n_up, with ij = xx, xy, xz, yy, yz, zz, m^4
    PackRow<Real> area;               ///< m^2
};

template <typename Real>
struct WetRows {
    PressureRows<Real> pressure;
    ShadowRows<Real> shadow;  ///< if asked for
};

/// What of the rows to sum up.
enum class WetRowsAsked { pressure, all };

struct PressureSums {
    double depth;
    double depthMoment[3];
};

/// The loops that the time goes into. Each instruction set sums the same numbers in the same order:
/// results are the same to the last bit.
template <typename Real>
struct ClipKernels {
    /// Adds the wet parts of the triangles of `count` packs, `which` of them, or the first ones if null.
    using Clip = void (*)(const TrianglePack<Real>* packs, const std::uint32_t* which, int count,
                          const PackPlane& plane, WetRows<Real>& rows);
    /// Adds the children of a cluster which are wholly wet, and lists those which the surface may cut.
    /// Returns how many these are.
    using Open = int (*)(const Cluster<Real>& cluster, const PackPlane& plane, WetRows<Real>& rows,
                         std::uint8_t* cut);

    /// What the first `count` packs come to, at once.
    using Press = PressureSums (*)(const TrianglePack<Real>* packs, int count, const PackPlane& plane);
    /// Sums up the parts.
    using Sum = PressureSums (*)(const PressureRows<Real>& rows);

    Clip clip[2];  ///< by WetRowsAsked
    Open open[2];
    Press press;
    Sum sum;
};

template <typename Real>
const ClipKernels<Real>& clipKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
