#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// Volume, first and second moment of a solid about the origin of its frame.
struct VolumeMoments {
    double volume = 0;                 ///< m^3
    Vec3 firstMoment = Vec3::Zero();   ///< integral of the position over the volume, m^4
    Mat3 secondMoment = Mat3::Zero();  ///< integral of r r^T over the volume, r the position, m^5

    /// m; the volume must not be zero.
    Vec3 centroid() const { return firstMoment / volume; }

    /// Of both solids: what they have in common counts twice.
    VolumeMoments& operator+=(const VolumeMoments& other) {
        volume += other.volume;
        firstMoment += other.firstMoment;
        secondMoment += other.secondMoment;
        return *this;
    }
};

/// What the surface encloses, by the divergence theorem: positive if its triangles face outward. For an open
/// mesh, the solid between the surface and the mean of its vertices.
VolumeMoments volumeMoments(const TriangleMesh& mesh);

/// The same solid farther by `offset`.
VolumeMoments moved(const VolumeMoments& moments, const Vec3& offset);

/// Sum of the triangles' areas, m^2.
double surfaceArea(const TriangleMesh& mesh);

}  // namespace bullet_buoyancy
