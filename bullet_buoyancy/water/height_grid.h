#pragma once

#include <vector>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"
#include "bullet_buoyancy/water/water_status.h"

namespace bullet_buoyancy {

/// Where the nodes of a grid lie.
struct HeightGridDef {
    int nodesX = 0;              ///< along the frame's x; at least two
    int nodesY = 0;              ///< along its y; at least two
    double spacing = 1;          ///< between nodes, m; above zero
    Vec2 origin = Vec2::Zero();  ///< where node (0, 0) is in the water's frame, m
    bool periodic = false;  ///< repeats after `nodesX` and `nodesY` spacings; else level beyond its edges
    bool moves = true;      ///< heights will be set again: bodies on the water may not sleep
    double density = freshWaterDensity;  ///< kg/m^3
};

/// A surface through heights at the nodes of a square grid, such as a game's own ocean: bicubic between them
/// (Catmull and Rom 1974), with continuous slopes. It stays as it is until it is given new heights.
///
/// All the water under a point moves up and down as its surface does, if the heights come with their rates of
/// change; else it is taken to be at rest. Pressure is hydrostatic.
class HeightGrid final : public WaterField {
public:
    /// Flat until it is given heights.
    HeightGrid(const WaterFrame& frame, const HeightGridDef& def);

    /// Whether the grid was accepted, and if not, why: a refused one is flat and takes no heights.
    const WaterStatus& status() const { return m_status; }

    /// Copies heights (m) and, if not null, their rates of change (m/s): `nodesX` times `nodesY` each, that
    /// of node (x, y) at x + y * nodesX. Not while another thread samples. Heights that are not finite are
    /// refused and change nothing. Costs about 0.1 microseconds a node.
    WaterStatus setHeights(const double* heights, const double* rates = nullptr);
    /// The same of single precision.
    WaterStatus setHeights(const float* heights, const float* rates = nullptr);

    WaterBounds bounds() const override { return m_bounds; }
    double curvatureNear(const Vec2& point, double radius, double time) const override;
    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override;
    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override;

private:
    int firstCell() const { return m_def.periodic ? 0 : -1; }

    template <typename Number>
    WaterStatus copy(const Number* heights, const Number* rates);
    Eigen::Matrix4d patch(const std::vector<double>& values, int cellX, int cellY) const;
    Eigen::Array3d interpolate(const std::vector<double>& values, double x, double y) const;
    void measure();

    HeightGridDef m_def;
    std::vector<double> m_heights, m_rates;
    std::vector<double> m_curvatures;  // of the cells, those beyond the edges first
    WaterStatus m_status;
    WaterBounds m_bounds;
};

}  // namespace bullet_buoyancy
