#pragma once

#include "bullet_buoyancy/hull/packs.h"
#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// A mesh as kernels read it, relative to `origin`. The children of cluster i of the lowest level are the
/// packs from 16 i on, those of a higher level the clusters from 16 i on of the level below. Levels end where
/// a few have all; a mesh of a few packs has none.
template <typename Real>
struct PackedTriangles {
    std::vector<TrianglePack<Real>> packs;
    std::vector<std::vector<Cluster<Real>>> levels;
};

/// Both precisions of a mesh.
struct PackedMesh {
    Vec3 origin = Vec3::Zero();  ///< in the body's frame, m
    /// Of what `single` displaces, by rounding corners, depths and areas to 6e-8 of themselves each, m^3.
    double errorOfSingle = 0;
    PackedTriangles<float> single;
    PackedTriangles<double> full;

    template <typename Real>
    const PackedTriangles<Real>& in() const;
};

template <>
inline const PackedTriangles<float>& PackedMesh::in() const {
    return single;
}
template <>
inline const PackedTriangles<double>& PackedMesh::in() const {
    return full;
}

/// Corners are rounded before anything is made of them, so that a closed mesh stays closed.
PackedMesh packMesh(const TriangleMesh& mesh, const Vec3& origin);

}  // namespace bullet_buoyancy
