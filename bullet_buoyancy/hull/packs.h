#pragma once

#include <cstdint>

namespace bullet_buoyancy {

/// Triangles a pack, and children a cluster: as many as the widest register has lanes.
inline constexpr int packSize = 16;

/// One number of each triangle of a pack, or of each child of a cluster.
template <typename Real>
struct alignas(64) PackRow {
    Real lane[packSize];
};

/// Neighbouring triangles side by side: x, y, z of their corners (m) and of the vector area (outward, m^2).
/// Those that fill up the last pack are points, without area.
template <typename Real>
struct TrianglePack {
    PackRow<Real> a[3], b[3], c[3], areaVector[3];
    PackRow<Real> area;  ///< m^2
};

/// Integrals over a child's surface, with n the outward normal and x the position: all that a pressure and a
/// depth which are linear over it can ask for.
template <typename Real>
struct MomentRows {
    PackRow<Real> normal[3];          ///< of n, m^2
    PackRow<Real> first[3][3];        ///< of x_i n_j, m^3
    PackRow<Real> second[6][3];       ///< of x_i x_j n_k, with ij = xx, xy, xz, yy, yz, zz, m^4
    PackRow<Real> unsignedNormal[3];  ///< of |n_i|, m^2
    PackRow<Real> area;               ///< m^2
};

/// Sixteen packs or clusters side by side: a box about each, and the moments of its surface. Those that are
/// not there have a box that is larger than nothing by a negative size, so that no plane cuts it.
template <typename Real>
struct Cluster {
    PackRow<Real> centre[3], halfExtents[3];  ///< of the box, m
    MomentRows<Real> moments;
};

}  // namespace bullet_buoyancy
