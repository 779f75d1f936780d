#pragma once

#include <limits>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::test {

/// Water whose elevation is height + slope . (x, y) + (curvature.x x^2 + curvature.y y^2) / 2, a tilted plane
/// or a paraboloid at rest. Its bounds hold up to 10 m from the frame's origin.
class QuadraticWater final : public WaterField {
public:
    explicit QuadraticWater(double height, const Vec2& slope, const Vec2& curvature = Vec2::Zero(),
                            const WaterFrame& frame = WaterFrame::zUp())
        : WaterField(frame, freshWaterDensity), m_height(height), m_slope(slope), m_curvature(curvature) {}

    WaterBounds bounds() const override {
        constexpr double reach = 10;
        const double curvature = m_curvature.cwiseAbs().maxCoeff();
        WaterBounds bounds;
        bounds.slope = m_slope.norm() + reach * curvature;
        bounds.elevation = std::abs(m_height) + reach * bounds.slope;
        bounds.curvature = curvature;
        bounds.curvatureChange = 0;
        return bounds;
    }

    void sampleSurface(HorizontalPoints points, double, SurfaceSamples samples) const override {
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const Vec2 p = points.row(i).matrix().transpose(), bend = m_curvature.cwiseProduct(p);
            samples(i, 0) = m_height + (m_slope + bend / 2).dot(p);
            samples(i, 1) = m_slope.x() + bend.x();
            samples(i, 2) = m_slope.y() + bend.y();
        }
    }

    void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const override {
        sampleSurface(points, time, expansions.leftCols<3>());
        expansions.col(3) = m_curvature.x();
        expansions.col(4) = 0;
        expansions.col(5) = m_curvature.y();
        expansions.col(6) = 0;
    }

    void sampleVelocity(WaterPoints, double, WaterVelocities velocities) const override {
        velocities.setZero();
    }

private:
    double m_height;
    Vec2 m_slope, m_curvature;
};

}  // namespace bullet_buoyancy::test
