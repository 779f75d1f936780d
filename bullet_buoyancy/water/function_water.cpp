#include "bullet_buoyancy/water/function_water.h"

#include <cassert>

namespace bullet_buoyancy {

FunctionWater::FunctionWater(const WaterFrame& frame, const FunctionWaterDef& def)
    : WaterField(frame, def.density), m_def(def) {
    assert(def.surface);
    // Without second derivatives of the surface nothing can be made of a bound of the third one.
    m_def.bounds.curvatureChange = def.bounds.isFlat() ? 0 : std::numeric_limits<double>::infinity();
}

void FunctionWater::sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row)
        samples.row(row) = m_def.surface(points(row, 0), points(row, 1), time).transpose();
}

void FunctionWater::sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const {
    velocities.setZero();
    if (!m_def.velocity) return;
    for (Eigen::Index row = 0; row < points.rows(); ++row)
        velocities.row(row) =
            m_def.velocity({points(row, 0), points(row, 1), points(row, 2)}, time).transpose().array();
}

}  // namespace bullet_buoyancy
