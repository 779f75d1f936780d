#include "bullet_buoyancy/water/water_field.h"

#include <cassert>
#include <cmath>

namespace bullet_buoyancy {

WaterField::WaterField(const WaterFrame& frame, double density) : m_frame(frame), m_density(density) {
    assert(std::isfinite(density) && density > 0);
}

void WaterField::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    sampleSurface(points, time, expansions.leftCols<3>());
    expansions.middleCols<3>(3).setZero();
    expansions.col(6) = bounds().curvatureChange;
}

double WaterField::curvatureNear(const Vec2&, double, double) const {
    return bounds().curvature;
}

void WaterField::expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const {
    expandSurface(points.leftCols<2>(), time, expansions.leftCols<7>());
    for (Eigen::Index column = 6; column > 3; --column)
        expansions.col(column) = expansions.col(column - 1);
    expansions.col(3).setZero();
    expansions.rightCols<3>().setZero();
}

double WaterField::headCurvatureChange(double above) const {
    return headCurvatureChangeUnder(bounds(), above);
}

double WaterField::headCurvatureChangeUnder(const WaterBounds&, double) const {
    return bounds().curvatureChange;
}

}  // namespace bullet_buoyancy
