#include "bullet_buoyancy/water/current.h"

#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

namespace {

WaterStatus check(const CurrentDef& def) {
    WaterStatus status;
    if (!def.velocityWorld.allFinite() || !std::isfinite(def.exponent))
        status.error = WaterError::notFinite;
    else if (!(def.depth > 0))
        status.error = WaterError::badDepth;
    else if (def.exponent < 0)
        status.error = WaterError::badProfile;
    return status;
}

}  // namespace

Current::Current(const WaterFrame& frame, const CurrentDef& def)
    : WaterField(frame, def.density), m_status(check(def)), m_depth(def.depth), m_exponent(def.exponent) {
    if (m_status.accepted()) m_velocity = frame.vectorFromWorld(def.velocityWorld);
}

WaterBounds Current::bounds() const {
    WaterBounds bounds;
    bounds.curvatureChange = 0;
    bounds.still = m_velocity.isZero(0);
    return bounds;
}

void Current::sampleSurface(HorizontalPoints, double, SurfaceSamples samples) const {
    samples.setZero();
}

void Current::sampleVelocity(WaterPoints points, double, WaterVelocities velocities) const {
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
        const double share = 1 + std::min(points(row, 2), 0.0) / m_depth;
        const double speed = share > 0 ? std::pow(share, m_exponent) : 0;
        velocities.row(row) = speed * m_velocity.transpose().array();
    }
}

}  // namespace bullet_buoyancy
