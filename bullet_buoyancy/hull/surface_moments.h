#pragma once

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

/// How much surface there is, where, and how it faces.
struct SurfaceMoments {
    double area = 0;                  ///< m^2
    Mat3 position = Mat3::Zero();     ///< integral of r r^T over the surface, r from the frame's origin, m^4
    Mat3 orientation = Mat3::Zero();  ///< integral of n n^T, n the unit normal, m^2
    Vec3 shadows = Vec3::Zero();      ///< half of the integral of |n| along the frame's axes, m^2

    /// Half of the integral of |n.direction|, from above, m^2: of a closed surface the area in which lines
    /// along the unit vector `direction` meet it, as often as they enter it.
    double shadowAlong(const Vec3& direction) const;

    /// No section, however the body lies, is larger: half of integral |n.up|, the largest shadow, is bounded
    /// by Cauchy and Schwarz. m^2.
    double largestSection() const;

    /// Half of the integral of the squared distance from each of the frame's axes, m^4: at least the second
    /// moment of any section of a convex body about that axis.
    Vec3 largestSecondMoments() const;

    /// Of both surfaces.
    SurfaceMoments& operator+=(const SurfaceMoments& other);
};

/// Exact: triangle by triangle, about the origin of the mesh's frame.
SurfaceMoments surfaceMoments(const TriangleMesh& mesh);

}  // namespace bullet_buoyancy
