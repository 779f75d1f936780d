#include "speed_vs_error/points_inside.h"

#include <Eigen/Geometry>
#include <cmath>

namespace bullet_buoyancy::demo {

namespace {

/// Lines along z through the grid's columns, and how often each point of them has been passed from below.
class Columns {
public:
    Columns(const Eigen::AlignedBox3d& box, int count)
        // A little off the middle of the cells, so that no line meets an edge of a symmetrical hull.
        : m_count(count),
          m_step(box.sizes() / count),
          m_first(box.min() + Vec3(0.5013, 0.4993, 0.5).cwiseProduct(m_step)),
          m_winding(std::size_t(count * count * count)) {}

    Vec3 point(int i, int j, int k) const { return m_first + m_step.cwiseProduct(Vec3(i, j, k)); }
    int& winding(int i, int j, int k) { return m_winding[std::size_t((i * m_count + j) * m_count + k)]; }

    void pass(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = (b - a).cross(c - a);
        if (normal.z() == 0) return;
        const auto [iBegin, iEnd] = linesAcross(0, a.x(), b.x(), c.x());
        const auto [jBegin, jEnd] = linesAcross(1, a.y(), b.y(), c.y());
        for (int i = iBegin; i < iEnd; ++i)
            for (int j = jBegin; j < jEnd; ++j)
                if (const Vec3 p = point(i, j, 0); isOver(p, a, b, c, normal.z()))
                    passAbove(i, j, a.z() - normal.head<2>().dot((p - a).head<2>()) / normal.z(),
                              normal.z() < 0 ? 1 : -1);
    }

private:
    std::pair<int, int> linesAcross(int axis, double a, double b, double c) const {
        const double low = (std::min({a, b, c}) - m_first[axis]) / m_step[axis],
                     high = (std::max({a, b, c}) - m_first[axis]) / m_step[axis];
        return {std::max(0, int(std::ceil(low))), std::min(m_count, int(std::floor(high)) + 1)};
    }

    static bool isOver(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double turn) {
        const auto isLeft = [&](const Vec3& from, const Vec3& to) {
            const double side = (to - from).x() * (p - from).y() - (to - from).y() * (p - from).x();
            return side * turn > 0;
        };
        return isLeft(a, b) && isLeft(b, c) && isLeft(c, a);
    }

    void passAbove(int i, int j, double height, int times) {
        const double k = std::ceil((height - m_first.z()) / m_step.z());
        for (int above = std::max(0, int(k)); above < m_count; ++above)
            winding(i, j, above) += times;
    }

    int m_count;
    Vec3 m_step, m_first;
    std::vector<int> m_winding;
};

}  // namespace

std::vector<Vec3> pointsInside(const TriangleMesh& mesh, int pointsAlong) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices)
        box.extend(vertex);
    Columns columns(box, pointsAlong);
    for (const Triangle& t : mesh.triangles)
        columns.pass(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    std::vector<Vec3> inside;
    for (int i = 0; i < pointsAlong; ++i)
        for (int j = 0; j < pointsAlong; ++j)
            for (int k = 0; k < pointsAlong; ++k)
                if (columns.winding(i, j, k) > 0) inside.push_back(columns.point(i, j, k));
    return inside;
}

}  // namespace bullet_buoyancy::demo
