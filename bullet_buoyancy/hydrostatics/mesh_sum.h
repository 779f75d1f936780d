#pragma once

namespace bullet_buoyancy {

/// How the triangles of a mesh under a plane of water are summed up. What comes out is the same but for
/// rounding.
enum class MeshSum {
    oneByOne,    ///< the law
    inPacks,     ///< many at a time, by vector instructions
    inClusters,  ///< the same, but clusters that are wholly wet by their moments
};

}  // namespace bullet_buoyancy
