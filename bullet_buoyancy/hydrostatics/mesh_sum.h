#pragma once

namespace bullet_buoyancy {

/// How the triangles of a mesh are summed up. Under a plane of water what comes out is the same but for
/// rounding, in waves within the tolerance; there packs are summed up as clusters are.
enum class MeshSum {
    oneByOne,    ///< the law
    inPacks,     ///< many at a time, by vector instructions
    inClusters,  ///< the same, but clusters that are wholly wet by their moments
};

}  // namespace bullet_buoyancy
