#include "bullet_buoyancy/hull/find_overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/overlap.h"
#include "bullet_buoyancy/hull/volume_moments.h"

namespace bullet_buoyancy {

namespace {

struct Solid {
    const TriangleMesh* mesh;
    Eigen::AlignedBox3d box;
    double volume;
};

struct Pair {
    const Solid *a, *b;
    double room;   // volume that both bounding boxes cover
    double least;  // overlap that counts

    bool operator<(const Pair& other) const { return room > other.room; }
};

/// In the order of their lower ends along x.
std::vector<Solid> sortedAlongX(const std::vector<TriangleMesh>& meshes) {
    std::vector<Solid> solids;
    for (const TriangleMesh& mesh : meshes) {
        solids.push_back({&mesh, {}, volumeMoments(mesh).volume});
        for (const Vec3& vertex : mesh.vertices)
            solids.back().box.extend(vertex);
    }
    std::sort(solids.begin(), solids.end(),
              [](const Solid& a, const Solid& b) { return a.box.min().x() < b.box.min().x(); });
    return solids;
}

/// Calls `visit` with every pair that may have enough in common.
template <typename Visit>
void forEachNearPair(const std::vector<Solid>& solids, const Visit& visit) {
    for (auto a = solids.begin(); a != solids.end(); ++a)
        for (auto b = a + 1; b != solids.end() && b->box.min().x() < a->box.max().x(); ++b) {
            const Eigen::AlignedBox3d common = a->box.intersection(b->box);
            const double least = overlapTolerance * std::max(0.0, std::min(a->volume, b->volume));
            if (!common.isEmpty() && common.volume() > least) visit(Pair{&*a, &*b, common.volume(), least});
        }
}

}  // namespace

Overlaps findOverlaps(const std::vector<TriangleMesh>& meshes, std::size_t limit) {
    const std::vector<Solid> solids = sortedAlongX(meshes);
    std::vector<Pair> pairs;  // a heap whose first has the least room
    Overlaps found;
    forEachNearPair(solids, [&](const Pair& pair) {
        pairs.push_back(pair);
        std::push_heap(pairs.begin(), pairs.end());
        if (pairs.size() <= limit) return;
        std::pop_heap(pairs.begin(), pairs.end());
        pairs.pop_back();
        ++found.uncheckedPairs;
    });
    for (const Pair& pair : pairs) {
        const double overlap = overlapVolume(*pair.a->mesh, *pair.b->mesh);
        if (overlap <= pair.least) continue;
        ++found.pairs;
        found.volume += overlap;
    }
    return found;
}

}  // namespace bullet_buoyancy
