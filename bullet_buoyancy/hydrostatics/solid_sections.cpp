#include "bullet_buoyancy/hydrostatics/solid_sections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

AxisInWater axisInWater(const SolidOfRevolution& solid, const WaterPlane& plane) {
    AxisInWater view;
    view.origin = solid.origin;
    view.axis = solid.axis;
    view.upAlong = plane.upInBody.dot(solid.axis);
    const Vec3 across = plane.upInBody - view.upAlong * solid.axis;
    view.upAcross = across.norm();
    view.rising = view.upAcross > 0 ? Vec3(across / view.upAcross) : solid.axis.unitOrthogonal();
    view.depthAtOrigin = plane.depth(solid.origin);
    return view;
}

std::array<double, 4> stretchEnds(const ProfilePiece& piece, const AxisInWater& view) {
    const double across2 = view.upAcross * view.upAcross;
    const double p0 = across2 * piece.c0 - view.depthAtOrigin * view.depthAtOrigin;
    const double p1 = across2 * piece.c1 + 2 * view.depthAtOrigin * view.upAlong;
    const double p2 = across2 * piece.c2 - view.upAlong * view.upAlong;
    const double discriminant = std::max(0.0, p1 * p1 - 4 * p0 * p2);
    const double q = -(p1 + std::copysign(std::sqrt(discriminant), p1)) / 2;
    const auto within = [&](double x) {
        return std::isfinite(x) ? std::clamp(x, piece.begin, piece.end) : piece.begin;
    };
    double root1 = within(q / p2), root2 = within(p0 / q);
    if (q == 0) root1 = root2 = within(0);
    return {piece.begin, std::min(root1, root2), std::max(root1, root2), piece.end};
}

}  // namespace bullet_buoyancy
