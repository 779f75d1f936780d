#pragma once

#include <cstddef>
#include <string>

namespace bullet_buoyancy {

/// Why there is no hull.
enum class HullError {
    none,              ///< there is one
    unsupportedShape,  ///< `HullStatus::reason` says why
    noTriangles,       ///< nothing to wet
    badIndices,        ///< a triangle names a vertex that does not exist
    notFinite,         ///< a coordinate, a volume or a moment is NaN or infinite
    flatPoints,        ///< the points of a convex hull lie in one plane
    noVolume,          ///< the surface encloses no volume
};

/// Why a hull was refused, or what was remarked about one that was accepted.
struct HullStatus {
    HullError error = HullError::none;    ///< why it was refused
    const char* reason = "";              ///< static text, for `unsupportedShape`
    std::size_t weldedVertices = 0;       ///< repeated or unused vertices taken out
    std::size_t degenerateTriangles = 0;  ///< triangles without area taken out
    std::size_t duplicateTriangles = 0;   ///< triangles that repeated another one, taken out
    std::size_t flippedTriangles = 0;     ///< triangles turned outward
    std::size_t openEdges = 0;            ///< above 0: pressure acts on the triangles that are there
    /// Pairs of parts, or of solids in one mesh, that overlap and displace the water there twice.
    std::size_t overlappingPairs = 0;
    double overlapVolume = 0;  ///< estimate of what is displaced twice, m^3
    /// Pairs of solids in one mesh that may overlap but were not checked: 1000 are.
    std::size_t uncheckedPairs = 0;
    double tessellationError =
        0;  ///< of smooth shapes without a formula: share of the volume that is uncertain

    /// There is a hull, with or without remarks.
    bool accepted() const { return error == HullError::none; }

    /// One line for people: the refusal, or the remarks, or "ok".
    std::string describe() const;
};

}  // namespace bullet_buoyancy
