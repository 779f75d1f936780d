#include "bullet_buoyancy/hydrostatics/displace_block.h"

#include "bullet_buoyancy/core/fill_rows.h"
#include "bullet_buoyancy/hydrostatics/clip_kernels.h"
#include "bullet_buoyancy/hydrostatics/level_kernels.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"

namespace bullet_buoyancy {

namespace {

/// All that the surface can cut is one mesh of a few packs.
bool isFewPacks(const Hull& hull) {
    return hull.spheres.empty() && hull.packed.full.levels.empty();
}

template <typename Real>
PressureSums press(const PackedTriangles<Real>& mesh, const PackPlane& plane) {
    return clipKernels<Real>().press(mesh.packs.data(), int(mesh.packs.size()), plane);
}

}  // namespace

void BlockDisplacement::setHull(int lane, const Hull& hull) {
    if (m_hull[lane] == &hull) return;
    m_hull[lane] = &hull;
    put(hull.bounds.centre, m_hulls.centre, lane);
    put(hull.moments.firstMoment, m_hulls.moment, lane);
    m_hulls.radius.lane[lane] = hull.bounds.radius;
    m_hulls.volume.lane[lane] = hull.moments.volume;
}

void BlockDisplacement::take(const LevelWater& water, const PoseRows& poses, Precision precision) {
    const LevelKernels& kernels = levelKernels();
    kernels.see(water, poses, m_hulls, m_planes);
    const bool inLanes = precision == Precision::full && haveOnePack();
    if (inLanes) {
        const Hull& hull = *m_hull[0];
        kernels.press(hull.packed.full.packs.front(), int(hull.mesh.triangles.size()), m_planes, m_sums);
    } else {
        for (int lane = 0; lane < blockSize; ++lane)
            if (isCut(lane) && isFewPacks(*m_hull[lane])) pressOne(lane, precision);
    }
    kernels.displace(m_hulls, m_planes, m_sums, m_displaced);
    if (inLanes) return;
    for (int lane = 0; lane < blockSize; ++lane)
        if (isCut(lane)) finish(lane, precision);
}

/// All of them the same.
bool BlockDisplacement::haveOnePack() const {
    const Hull& hull = *m_hull[0];
    for (int lane = 1; lane < blockSize; ++lane)
        if (m_hull[lane] != &hull) return false;
    return isFewPacks(hull) && hull.packed.full.packs.size() == 1;
}

void BlockDisplacement::pressOne(int lane, Precision precision) {
    const Vec3 up = get(m_planes.upInBody, lane);
    const PackPlane plane{{up.x(), up.y(), up.z()}, m_planes.depthOfCentre.lane[lane]};
    const PackedMesh& mesh = m_hull[lane]->packed;
    const PressureSums sums =
        precision == Precision::single ? press(mesh.single, plane) : press(mesh.full, plane);
    m_sums.depth.lane[lane] = sums.depth;
    m_sums.depthMoment.x.lane[lane] = sums.depthMoment[0];
    m_sums.depthMoment.y.lane[lane] = sums.depthMoment[1];
    m_sums.depthMoment.z.lane[lane] = sums.depthMoment[2];
}

/// Large meshes and what has spheres are taken by themselves.
void BlockDisplacement::finish(int lane, Precision precision) {
    const Hull& hull = *m_hull[lane];
    if (isFewPacks(hull)) {
        if (precision == Precision::single) m_displaced.error.lane[lane] = hull.packed.errorOfSingle;
        return;
    }
    const WaterPlane plane{get(m_planes.upInBody, lane), m_planes.heightOfWater.lane[lane]};
    const Displacement displaced = displacementUnderPlane(hull, plane, MeshSum::inClusters, precision);
    m_displaced.volume.lane[lane] = displaced.volume;
    put(displaced.volumeMoment, m_displaced.volumeMoment, lane);
    m_displaced.headVolume.lane[lane] = displaced.headVolume;
    m_displaced.error.lane[lane] = displaced.error;
}

}  // namespace bullet_buoyancy
