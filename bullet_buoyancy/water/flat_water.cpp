#include "bullet_buoyancy/water/flat_water.h"

#include <cassert>

namespace bullet_buoyancy {

FlatWater::FlatWater(const WaterFrame& frame, const FlatWaterDef& def)
    : WaterField(frame, def.density), m_flowVelocity(frame.vectorFromWorld(def.flowVelocityWorld)) {
    assert(def.flowVelocityWorld.allFinite());
}

WaterBounds FlatWater::bounds() const {
    WaterBounds bounds;
    bounds.curvatureChange = 0;
    bounds.still = m_flowVelocity.isZero(0);
    return bounds;
}

void FlatWater::sampleSurface(HorizontalPoints, double, SurfaceSamples samples) const {
    samples.setZero();
}

void FlatWater::sampleVelocity(WaterPoints, double, WaterVelocities velocities) const {
    velocities.rowwise() = m_flowVelocity.transpose().array();
}

}  // namespace bullet_buoyancy
