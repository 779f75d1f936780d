#include "bullet_buoyancy/hydrostatics/reference_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bullet_buoyancy/core/quadrature.h"
#include "bullet_buoyancy/hydrostatics/clip_triangle.h"
#include "bullet_buoyancy/hydrostatics/reference_element.h"

namespace bullet_buoyancy {

namespace {

constexpr int quarterings =
    12;  // cells of 2^-12 of a triangle's side: an error at the waterline of their square

/// Strang's three-point rule, exact for quadratics, where the triangle is wholly wet; quarters where it is
/// cut.
void addTriangle(const DepthPoint& a, const DepthPoint& b, const DepthPoint& c, int level, const Vec3& up,
                 WetIntegrals& sums) {
    const auto [least, most] = std::minmax({a.depth, b.depth, c.depth});
    if (most <= 0) return;
    const auto middle = [](const DepthPoint& p, const DepthPoint& q) {
        return DepthPoint{(p.position + q.position) / 2, (p.depth + q.depth) / 2};
    };
    const DepthPoint ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    if (least >= 0 || level == quarterings) {
        const Vec3 third = (b.position - a.position).cross(c.position - a.position) / 6;
        for (const DepthPoint* p : {&ab, &bc, &ca})
            if (p->depth > 0) addElement(p->position, p->depth, p->depth, third, up, sums);
        return;
    }
    addTriangle(a, ab, ca, level + 1, up, sums);
    addTriangle(ab, b, bc, level + 1, up, sums);
    addTriangle(ca, bc, c, level + 1, up, sums);
    addTriangle(ab, bc, ca, level + 1, up, sums);
}

/// A solid of revolution in the water: `rising` lies across the axis in the plane of axis and up.
struct SolidInWater {
    const SolidOfRevolution& solid;
    const WaterPlane& plane;
    Vec3 rising, sideways;
    double upAcross;

    SolidInWater(const SolidOfRevolution& s, const WaterPlane& p) : solid(s), plane(p) {
        const Vec3 across = p.upInBody - p.upInBody.dot(s.axis) * s.axis;
        upAcross = across.norm();
        rising = upAcross > 0 ? Vec3(across / upAcross) : s.axis.unitOrthogonal();
        sideways = s.axis.cross(rising);
    }

    /// Calls `visit(cosine, sine, weight)` over the angles at which the circle of radius r at x is wet.
    template <typename Visit>
    void roundWetArc(double x, double radius, const Visit& visit) const {
        static const GaussLegendre<16> rule;
        const double depthOnAxis = plane.depth(solid.origin + x * solid.axis);
        const double reach = upAcross * radius;
        const double dryHalf = depthOnAxis >= reach    ? 0
                               : depthOnAxis <= -reach ? pi
                                                       : std::acos(depthOnAxis / reach);
        const double half = pi - dryHalf;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double angle = pi + half * rule.nodes[i];
            visit(std::cos(angle), std::sin(angle), half * rule.weights[i]);
        }
    }

    Vec3 radial(double cosine, double sine) const { return cosine * rising + sine * sideways; }

    void addRing(const ProfilePiece& piece, double x, double weight, WetIntegrals& sums) const {
        const double radius = std::sqrt(std::max(0.0, piece.radiusSquared(x)));
        const double radiusTimesSlope = piece.c1 / 2 + x * piece.c2;
        roundWetArc(x, radius, [&](double cosine, double sine, double angleWeight) {
            const Vec3 outward = radial(cosine, sine);
            const Vec3 position = solid.origin + x * solid.axis + radius * outward;
            const double depth = plane.depth(position);
            addElement(position, depth, depth,
                       weight * angleWeight * (radius * outward - radiusTimesSlope * solid.axis),
                       plane.upInBody, sums);
        });
    }

    /// Depth of the deepest (side 1) or highest (side -1) point of the section at x; concave or convex along
    /// a piece.
    double depthOfSection(const ProfilePiece& piece, double x, double side) const {
        const double radius = std::sqrt(std::max(0.0, piece.radiusSquared(x)));
        return plane.depth(solid.origin + x * solid.axis) + side * upAcross * radius;
    }

    /// Where the deepest or highest points along a piece cross the surface: at most once on either side of
    /// where they are deepest or highest.
    std::array<double, 3> crossings(const ProfilePiece& piece, double side) const {
        const auto value = [&](double x) { return side * depthOfSection(piece, x, side); };
        double low = piece.begin, high = piece.end;
        for (int i = 0; i < 200; ++i) {
            const double left = low + (high - low) / 3, right = high - (high - low) / 3;
            (value(left) < value(right) ? low : high) = value(left) < value(right) ? left : right;
        }
        const double peak = (low + high) / 2;
        const auto bisect = [&](double inside, double outside) {
            if ((value(inside) > 0) == (value(outside) > 0)) return outside;
            for (int i = 0; i < 100; ++i) {
                const double middle = (inside + outside) / 2;
                ((value(middle) > 0) == (value(inside) > 0) ? inside : outside) = middle;
            }
            return inside;
        };
        return {bisect(peak, piece.begin), peak, bisect(peak, piece.end)};
    }

    void addPiece(const ProfilePiece& piece, WetIntegrals& sums) const {
        static const SineQuadrature<32> alongAxis;
        std::vector<double> ends{piece.begin, piece.end};
        for (double side : {1.0, -1.0})
            for (double x : crossings(piece, side))
                ends.push_back(x);
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            if (depthOfSection(piece, (ends[i] + ends[i + 1]) / 2, 1) <= 0) continue;
            alongAxis.over(ends[i], ends[i + 1],
                           [&](double x, double weight) { addRing(piece, x, weight, sums); });
        }
    }

    /// A flat end, as the lines s = constant across the disc, down to where the surface cuts it.
    void addDisc(double x, double radius, double outwardSign, WetIntegrals& sums) const {
        static const SineQuadrature<32> alongS;
        static const GaussLegendre<4> acrossS;
        const double depthOnAxis = plane.depth(solid.origin + x * solid.axis);
        const double reach = upAcross * radius;
        const double end = depthOnAxis >= reach    ? radius
                           : depthOnAxis <= -reach ? -radius
                                                   : depthOnAxis / upAcross;
        alongS.over(-radius, end, [&](double s, double weight) {
            const double half = std::sqrt(std::max(0.0, radius * radius - s * s));
            for (std::size_t i = 0; i < acrossS.nodes.size(); ++i) {
                const Vec3 position =
                    solid.origin + x * solid.axis + s * rising + half * acrossS.nodes[i] * sideways;
                const double depth = plane.depth(position);
                addElement(position, depth, depth,
                           outwardSign * weight * half * acrossS.weights[i] * solid.axis, plane.upInBody,
                           sums);
            }
        });
    }
};

}  // namespace

void addReferenceSurface(const TriangleMesh& mesh, const WaterPlane& plane, WetIntegrals& integrals) {
    const auto corner = [&](std::uint32_t index) {
        return DepthPoint{mesh.vertices[index], plane.depth(mesh.vertices[index])};
    };
    for (const Triangle& t : mesh.triangles)
        addTriangle(corner(t[0]), corner(t[1]), corner(t[2]), 0, plane.upInBody, integrals);
}

void addReferenceSurface(const SolidOfRevolution& solid, const WaterPlane& plane, WetIntegrals& integrals) {
    const SolidInWater inWater(solid, plane);
    for (const ProfilePiece& piece : solid.profile)
        inWater.addPiece(piece, integrals);
    const ProfilePiece &first = solid.profile.front(), &last = solid.profile.back();
    inWater.addDisc(first.begin, std::sqrt(std::max(0.0, first.radiusSquared(first.begin))), -1, integrals);
    inWater.addDisc(last.end, std::sqrt(std::max(0.0, last.radiusSquared(last.end))), 1, integrals);
}

}  // namespace bullet_buoyancy
