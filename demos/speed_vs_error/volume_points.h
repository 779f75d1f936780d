#pragma once

#include "speed_vs_error/evaluators.h"

namespace bullet_buoyancy::demo {

/// A share of a hull's volume about a point, wet by a linear law of the point's depth.
struct VolumePoint {
    Vec3 position;  ///< body's frame, m
    double volume;  ///< m^3
};

struct VolumePoints {
    std::vector<VolumePoint> points;
    Vec3 cell;  ///< edges of the box that one fills, along the body's axes, m
};

/// As a careful designer would set them: each in the middle of what is nearer to it than to the others
/// (Lloyd 1982), with as much of the volume.
VolumePoints pontoonsOf(const Hull& hull, int count);

/// The parts of the hull in the cells of a grid over its box, `cellsAlong` each of its edges: volumes and
/// centroids.
VolumePoints voxelsOf(const Hull& hull, int cellsAlong);

/// Lifts each point by what of its volume is wet, in single precision: that grows from none to all while the
/// point sinks through the height of its cell.
std::unique_ptr<ReadyEvaluator> pressPoints(const VolumePoints& points, const WaterField& water);

}  // namespace bullet_buoyancy::demo
