#pragma once

#include <vector>

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// The water as seen from a body: every point asked of the field itself, nothing interpolated.
class WaterAroundBody {
public:
    /// Keeps a reference to `water`.
    WaterAroundBody(const Pose& pose, const WaterField& water, const HydrostaticQuery& query);

    /// The vertical, in the body's frame.
    Vec3 upInBody() const { return m_frameFromBody.row(2).transpose(); }

    /// The slope that depth has at most along any direction, m/m.
    double steepness() const;
    /// The second derivative that depth has at most along any direction, 1/m.
    double curvature() const { return m_bounds.curvature; }

    /// How far the surface is straight above each point of the body: above zero under water, m.
    std::vector<double> depths(const std::vector<Vec3>& pointsInBody);

    /// Gauge pressure over rho g at points of given depths, m; zero at the surface.
    std::vector<double> heads(const std::vector<Vec3>& pointsInBody, const std::vector<double>& depths);

    /// -grad(depth) in world axes at the surface straight above or below a point: the vertical leant against
    /// the slope.
    Vec3 surfaceGradientWorld(const Vec3& pointFromComWorld);

    int samples() const { return m_samples; }

private:
    Vec3 inFrame(const Vec3& pointInBody) const { return m_comInFrame + m_frameFromBody * pointInBody; }

    const WaterField& m_water;
    WaterBounds m_bounds;
    PressureModel m_model;
    double m_time;
    Mat3 m_frameFromBody;
    Vec3 m_comInFrame;
    int m_samples = 0;
};

}  // namespace bullet_buoyancy
