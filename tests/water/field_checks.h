#pragma once

#include <functional>

#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::test {

/// One place at one time, for fields that are asked for many.
Eigen::Array3d surfaceAt(const WaterField& water, double x, double y, double time);
Eigen::Array<double, 7, 1> expansionAt(const WaterField& water, double x, double y, double time);
Eigen::Array<double, 10, 1> headAt(const WaterField& water, double x, double y, double s, double time);
Vec3 velocityAt(const WaterField& water, const Vec3& point, double time);

/// Where derivatives are compared with differences, and how closely.
struct DerivativeCheck {
    double step = 1e-4;       ///< m
    double tolerance = 1e-8;  ///< of slopes, m/m, and of second derivatives, 1/m
    double halfSize = 100;    ///< of the square in which they are compared, m
};

/// `expandSurface` agrees with `sampleSurface`, and all derivatives with central differences.
void expectSurfaceDerivatives(const WaterField& water, const DerivativeCheck& check = {});

/// The same of `expandWaveHead`; and at the surface it is the elevation.
void expectHeadDerivatives(const WaterField& water, const DerivativeCheck& check = {});

/// The largest value that a search finds of a function of x, y in m, time in s, an angle and a share from 0
/// to 1: at random, then uphill from the best.
using Target = std::function<double(double x, double y, double time, double angle, double share)>;
double searchLargest(const Target& target, double halfSize);

/// The largest that a search finds of what `bounds()` bounds.
WaterBounds searchBounds(const WaterField& water, double halfSize, bool thirdToo);

/// The same of the third derivative of the head between two heights over the surface, m.
double searchHeadCurvatureChange(const WaterField& water, double halfSize, double deepest, double above);

}  // namespace bullet_buoyancy::test
