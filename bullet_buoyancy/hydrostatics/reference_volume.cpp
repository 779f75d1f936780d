#include "bullet_buoyancy/hydrostatics/reference_volume.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>

#include "bullet_buoyancy/hydrostatics/clip_triangle.h"

namespace bullet_buoyancy {

namespace {

using Tetrahedron = std::array<DepthPoint, 4>;

double signedVolume(const Tetrahedron& t) {
    const Vec3 &a = t[0].position, &b = t[1].position, &c = t[2].position, &d = t[3].position;
    return (b - a).cross(c - a).dot(d - a) / 6;
}

/// Displacement under water, positive or negative, summed over tetrahedra.
struct Tetrahedra : Displacement {
    void add(const Tetrahedron& t, double sign) {
        const double size = sign * std::abs(signedVolume(t));
        volume += size;
        volumeMoment += size / 4 * (t[0].position + t[1].position + t[2].position + t[3].position);
        headVolume += size / 4 * (t[0].depth + t[1].depth + t[2].depth + t[3].depth);
    }

    /// The part of a tetrahedron that is under water; by the number of its wet corners a tetrahedron, a wedge
    /// (as three tetrahedra), or what a dry tetrahedron leaves of it.
    void addWetPart(Tetrahedron t, double sign) {
        std::sort(t.begin(), t.end(),
                  [](const DepthPoint& p, const DepthPoint& q) { return p.depth > q.depth; });
        const auto wet = std::count_if(t.begin(), t.end(), [](const DepthPoint& p) { return p.depth > 0; });
        const auto cut = [&](std::size_t i, std::size_t j) { return waterlinePoint(t[i], t[j]); };
        if (wet == 4) add(t, sign);
        if (wet == 3) {
            add(t, sign);
            add({t[3], cut(0, 3), cut(1, 3), cut(2, 3)}, -sign);
        }
        if (wet == 2) {
            const DepthPoint ac = cut(0, 2), ad = cut(0, 3), bc = cut(1, 2), bd = cut(1, 3);
            add({t[0], t[1], bc, bd}, sign);
            add({t[0], ac, ad, bc}, sign);
            add({t[0], ad, bc, bd}, sign);
        }
        if (wet == 1) add({t[0], cut(0, 1), cut(0, 2), cut(0, 3)}, sign);
    }
};

/// Where the surface of the water cuts a triangle, if it does: from one of its sides to another.
std::optional<std::array<Vec3, 2>> waterlineSegment(const std::array<DepthPoint, 3>& triangle) {
    std::array<Vec3, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const DepthPoint &p = triangle[i], &q = triangle[(i + 1) % 3];
        if ((p.depth > 0) == (q.depth > 0)) continue;
        ends[count++] = (p.depth > 0 ? waterlinePoint(p, q) : waterlinePoint(q, p)).position;
    }
    if (count != 2) return std::nullopt;
    return ends;
}

/// The triangle from `apex` (a point of the surface) to a piece of the waterline, signed by the side on which
/// the hull lies: seen from above the outline runs counter-clockwise, along up x outward normal.
void addSector(const std::array<Vec3, 2>& segment, const Vec3& outward, const Vec3& apex, const Vec3& up,
               WetIntegrals& integrals) {
    const bool forward = (segment[1] - segment[0]).dot(up.cross(outward)) > 0;
    const Vec3 &p = segment[forward ? 0 : 1], &q = segment[forward ? 1 : 0];
    const double area = (p - apex).cross(q - apex).dot(up) / 2;
    const Vec3 centre = (apex + p + q) / 3;
    const Vec3 da = apex - centre, dp = p - centre, dq = q - centre;
    integrals.addWaterplane(area, centre,
                            area / 12 * (da * da.transpose() + dp * dp.transpose() + dq * dq.transpose()));
}

}  // namespace

void addReferenceVolume(const TriangleMesh& mesh, const WaterPlane& plane, WetIntegrals& integrals) {
    if (mesh.triangles.empty()) return;
    const auto corner = [&](std::uint32_t index) {
        return DepthPoint{mesh.vertices[index], plane.depth(mesh.vertices[index])};
    };
    const DepthPoint apex = corner(mesh.triangles[0][0]);
    const Vec3 apexOnSurface = apex.position + apex.depth * plane.upInBody;
    Tetrahedra displacement;
    for (const Triangle& t : mesh.triangles) {
        const std::array<DepthPoint, 3> triangle{corner(t[0]), corner(t[1]), corner(t[2])};
        const Tetrahedron tetrahedron{apex, triangle[0], triangle[1], triangle[2]};
        displacement.addWetPart(tetrahedron, signedVolume(tetrahedron) < 0 ? -1 : 1);
        const Vec3 areaVector =
            (triangle[1].position - triangle[0].position).cross(triangle[2].position - triangle[0].position) /
            2;
        integrals.wettedArea +=
            areaVector.norm() * wetShare(triangle[0].depth, triangle[1].depth, triangle[2].depth);
        if (const auto segment = waterlineSegment(triangle))
            addSector(*segment, areaVector, apexOnSurface, plane.upInBody, integrals);
    }
    integrals.addDisplacement(plane.upInBody, displacement);
}

}  // namespace bullet_buoyancy
