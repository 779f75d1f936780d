#pragma once

#include <cstddef>

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy {

struct Overlaps {
    std::size_t pairs = 0;
    double volume = 0;               ///< summed over the pairs, estimated, m^3
    std::size_t uncheckedPairs = 0;  ///< near each other, but beyond the limit
};

/// Pairs of closed outward solids that have more than `overlapTolerance` of the smaller one in common. Of the
/// pairs whose bounding boxes let them, the limit's number with the most room in common are measured.
Overlaps findOverlaps(const std::vector<TriangleMesh>& solids, std::size_t limit);

}  // namespace bullet_buoyancy
