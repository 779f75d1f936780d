#pragma once

#include <array>
#include <memory>
#include <vector>

#include "bullet_buoyancy/hull/hull.h"

namespace bullet_buoyancy {

/// A point of a hull's surface, in the body's frame.
struct PatchPoint {
    Vec3 position;    ///< m
    Vec3 areaVector;  ///< along the outward normal, m^2 per unit of the parameters' area
};

/// Bounds of how a patch runs along a step of its parameters.
struct StepBounds {
    double lengthSquared;  ///< of the first derivative of position along the step, m^2
    double bend;           ///< of the second derivative, m
};

using ParameterTriangle = std::array<Vec2, 3>;

/// A smooth piece of a hull's surface as a function of two parameters.
class SurfacePatch {
public:
    virtual ~SurfacePatch() = default;

    /// The patch is what lies over these triangles.
    virtual std::vector<ParameterTriangle> domain() const = 0;

    virtual PatchPoint at(const Vec2& parameters) const = 0;

    /// Hold all over a cell of the domain. Quadratic in the step.
    virtual StepBounds alongStep(const ParameterTriangle& cell, const Vec2& step) const = 0;
};

/// The whole surface of a hull: a patch for each triangle, each piece of the side of a solid of revolution
/// and each of its flat ends.
std::vector<std::unique_ptr<const SurfacePatch>> patchesOf(const Hull& hull);

}  // namespace bullet_buoyancy
