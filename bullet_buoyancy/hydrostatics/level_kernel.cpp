// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/core/body_lanes.h"
#include "bullet_buoyancy/hydrostatics/cut_triangles.h"
#include "bullet_buoyancy/hydrostatics/level_kernels.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

void see(const LevelWater& water, const PoseRows& poses, const HullRows& hulls, PlaneRows& planes) {
    const Vectors up = spread(water.up), origin = spread(water.origin);
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const Rotations axes(load(poses.orientation, lane));
        const Vectors upInBody = axes.transposed(up);
        const Numbers height = -up.dot(load(poses.position, lane) - origin);
        const Numbers depth = height - upInBody.dot(load(hulls.centre, lane)),
                      radius = load(hulls.radius, lane);
        store(upInBody, planes.upInBody, lane);
        store(height, planes.heightOfWater, lane);
        store(depth, planes.depthOfCentre, lane);
        store(((depth > -radius) & (depth < radius)) ? spread(1.0) : Numbers{}, planes.isCut, lane);
    }
}

/// In each body.
struct Pressures {
    Numbers depth;
    Vectors moment;

    Pressures operator+(const Pressures& o) const { return {depth + o.depth, moment + o.moment}; }
};

Pressures ofTriangle(const TrianglePack<double>& pack, int triangle, const LanePlane<double>& plane) {
    const auto vector = [&](const PackRow<double>(&rows)[3]) {
        return Vectors{spread(rows[0].lane[triangle]), spread(rows[1].lane[triangle]),
                       spread(rows[2].lane[triangle])};
    };
    const CutTriangles<double> cut(vector(pack.a), vector(pack.b), vector(pack.c), plane);
    Pressures of{};
    cut.addPressure(plane.up.dot(vector(pack.areaVector)), of.depth, of.moment);
    return {spread(1.0 / 3) * of.depth, spread(1.0 / 12) * of.moment};
}

/// By halves, in the order in which the rows of a pack are summed up: `distance` is that of its triangles.
template <int distance>
Pressures sumFrom(int first, const TrianglePack<double>& pack, int count, const LanePlane<double>& plane) {
    if constexpr (distance == packSize) {
        return ofTriangle(pack, first, plane);
    } else {
        const Pressures sum = sumFrom<2 * distance>(first, pack, count, plane);
        if (first + distance >= count) return sum;
        return sum + sumFrom<2 * distance>(first + distance, pack, count, plane);
    }
}

void press(const TrianglePack<double>& pack, int count, const PlaneRows& planes, PressureSumRows& sums) {
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const LanePlane<double> plane{load(planes.upInBody, lane), load(planes.depthOfCentre, lane)};
        const Pressures total = sumFrom<1>(0, pack, count, plane);
        store(total.depth, sums.depth, lane);
        store(total.moment, sums.depthMoment, lane);
    }
}

/// By the divergence theorem with d up, which vanishes at the surface. What depth is integrated over the
/// volume follows: up . x = depth of the centre - d.
void displace(const HullRows& hulls, const PlaneRows& planes, const PressureSumRows& sums,
              DisplacementRows& displaced) {
    const Numbers none{};
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const Vectors up = load(planes.upInBody, lane), centre = load(hulls.centre, lane);
        const Numbers depth = load(planes.depthOfCentre, lane);
        const Numbers cutVolume = -load(sums.depth, lane);
        const Vectors cutMoment = spread(-1.0) * load(sums.depthMoment, lane);
        const Numbers cutHead = (depth * cutVolume - up.dot(cutMoment)) * 0.5;
        const Outcomes isCut = load(planes.isCut, lane) > none, isDry = depth <= none;

        const Numbers volume = load(hulls.volume, lane);
        const Vectors moment = load(hulls.moment, lane), nothing{};
        const Numbers head = load(planes.heightOfWater, lane) * volume - up.dot(moment);
        store(isCut ? cutVolume : (isDry ? none : volume), displaced.volume, lane);
        store(select<double>(isCut, cutMoment + cutHead * up + cutVolume * centre,
                             select<double>(isDry, nothing, moment)),
              displaced.volumeMoment, lane);
        store(isCut ? cutHead : (isDry ? none : head), displaced.headVolume, lane);
        store(none, displaced.error, lane);
    }
}

}  // namespace

extern const LevelKernels levelKernels;

const LevelKernels levelKernels = {see, press, displace};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
