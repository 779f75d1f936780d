#include "bullet_buoyancy/hull/overlap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

namespace {

constexpr int columnsPerSide = 64;

/// A surface crossed by a column, going up: into a solid (+1) or out of it (-1).
struct Crossing {
    double height;
    std::array<int, 2> windingChange;  // of mesh a, of mesh b
};

using Columns = std::vector<std::vector<Crossing>>;

/// Columns stand along z on a grid over the box.
struct Grid {
    Eigen::AlignedBox3d box;

    Vec2 position(int i, int j) const {
        const Vec2 fraction((i + 0.5) / columnsPerSide, (j + 0.5) / columnsPerSide);
        return box.min().head<2>() + fraction.cwiseProduct(box.sizes().head<2>());
    }

    /// Columns which something that reaches from or to a coordinate may meet, for all that rounding does.
    int firstIndex(double coordinate, int axis) const {
        return int(std::floor(fractional(coordinate, axis)));
    }
    int lastIndex(double coordinate, int axis) const { return int(std::ceil(fractional(coordinate, axis))); }

    double columnArea() const {
        return box.sizes().x() * box.sizes().y() / (columnsPerSide * columnsPerSide);
    }

private:
    double fractional(double coordinate, int axis) const {
        const double index = (coordinate - box.min()[axis]) / box.sizes()[axis] * columnsPerSide - 0.5;
        return std::clamp(index, -1.0, double(columnsPerSide));
    }
};

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether p lies to the left of the edge from a to b, decided alike for both triangles at the edge. A point
/// on it counts as if it were moved a little along x and far less along y (simulation of simplicity:
/// Edelsbrunner and Muecke 1990), so that a column through edges and corners crosses a closed surface as
/// often in as out.
bool leftOf(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, const Vec2& p) {
    if (a > b) return !leftOf(mesh, b, a, p);
    const Vec2 from = mesh.vertices[a].head<2>(), edge = mesh.vertices[b].head<2>() - from;
    const double side = cross(edge, p - from);
    if (side != 0) return side > 0;
    return edge.y() != 0 ? edge.y() < 0 : edge.x() > 0;
}

void addCrossings(const TriangleMesh& mesh, std::size_t which, const Grid& grid, Columns& columns) {
    for (const Triangle& triangle : mesh.triangles) {
        const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                   &c = mesh.vertices[triangle[2]];
        const double doubleArea = cross((b - a).head<2>(), (c - a).head<2>());
        if (doubleArea == 0) continue;
        const bool facesUp = doubleArea > 0;
        const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        const auto crosses = [&](const Vec2& p) {
            return leftOf(mesh, triangle[0], triangle[1], p) == facesUp &&
                   leftOf(mesh, triangle[1], triangle[2], p) == facesUp &&
                   leftOf(mesh, triangle[2], triangle[0], p) == facesUp;
        };
        for (int i = std::max(0, grid.firstIndex(low.x(), 0));
             i <= std::min(columnsPerSide - 1, grid.lastIndex(high.x(), 0)); ++i)
            for (int j = std::max(0, grid.firstIndex(low.y(), 1));
                 j <= std::min(columnsPerSide - 1, grid.lastIndex(high.y(), 1)); ++j) {
                const Vec2 p = grid.position(i, j);
                if (!crosses(p)) continue;
                const double wa = cross((c - b).head<2>(), p - b.head<2>()) / doubleArea;
                const double wb = cross((a - c).head<2>(), p - c.head<2>()) / doubleArea;
                const double height = wa * a.z() + wb * b.z() + (1 - wa - wb) * c.z();
                Crossing crossing{std::clamp(height, low.z(), high.z()), {0, 0}};
                crossing.windingChange[which] = facesUp ? -1 : 1;
                columns[std::size_t(i * columnsPerSide + j)].push_back(crossing);
            }
    }
}

double lengthInsideBoth(std::vector<Crossing>& column) {
    std::sort(column.begin(), column.end(),
              [](const Crossing& p, const Crossing& q) { return p.height < q.height; });
    double length = 0;
    std::array<int, 2> winding{0, 0};
    for (std::size_t i = 0; i + 1 < column.size(); ++i) {
        for (std::size_t which : {0u, 1u})
            winding[which] += column[i].windingChange[which];
        if (winding[0] > 0 && winding[1] > 0) length += column[i + 1].height - column[i].height;
    }
    return length;
}

Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices)
        box.extend(vertex);
    return box;
}

}  // namespace

double overlapVolume(const TriangleMesh& a, const TriangleMesh& b) {
    const Grid grid{boundingBox(a).intersection(boundingBox(b))};
    if (grid.box.isEmpty() || grid.box.volume() == 0) return 0;
    Columns columns(std::size_t(columnsPerSide) * columnsPerSide);
    addCrossings(a, 0, grid, columns);
    addCrossings(b, 1, grid, columns);
    double length = 0;
    for (std::vector<Crossing>& column : columns)
        length += lengthInsideBoth(column);
    return length * grid.columnArea();
}

}  // namespace bullet_buoyancy
