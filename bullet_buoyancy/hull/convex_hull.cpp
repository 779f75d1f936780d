#include "bullet_buoyancy/hull/convex_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <queue>
#include <unordered_map>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/exact_determinant.h"

namespace bullet_buoyancy {

namespace {

using Index = std::uint32_t;

constexpr int latticeBits = 50;

/// The points in whole numbers up to 2^latticeBits: a rounding below that of their own coordinates, after
/// which differences and determinants, and with them what is visible from where, are free of rounding. Empty
/// if the points are all in one place.
std::vector<Vec3> onLattice(const std::vector<Vec3>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    const double extent = points.empty() ? 0 : box.sizes().maxCoeff();
    if (!(extent > 0)) return {};
    const double scale = std::ldexp(1.0, latticeBits - std::ilogb(extent));
    std::vector<Vec3> onLattice;
    for (const Vec3& point : points)
        onLattice.push_back(((point - box.center()) * scale).array().round());
    return onLattice;
}

struct Face {
    Triangle corners;
    std::array<Index, 3> neighbours;  // across the side from corner i to corner i + 1
    std::vector<Index> outside;       // points that only this face is asked to swallow
    bool alive = true;
};

struct HorizonEdge {
    Index from, to;
    Index beyond;  // the face that stays
};

/// A face that has points outside, and how far the farthest of them is.
struct Pending {
    double farthest;
    Index face;

    bool operator<(const Pending& other) const { return farthest < other.farthest; }
};

/// Lengths are in units of the lattice.
class Quickhull {
public:
    explicit Quickhull(const std::vector<Vec3>& points) : m_points(onLattice(points)) {
        Eigen::AlignedBox3d box;
        for (const Vec3& point : m_points)
            box.extend(point);
        m_size = m_points.empty() ? 0 : box.diagonal().norm();
        m_tolerance = convexHullTolerance * m_size;
    }

    /// Triangles between the points.
    std::vector<Triangle> run() {
        if (m_points.empty() || !startWithTetrahedron()) return {};
        while (!m_pending.empty()) {
            const Index face = m_pending.top().face;
            m_pending.pop();
            if (m_faces[face].alive && !m_faces[face].outside.empty()) swallowFarthest(face);
        }
        std::vector<Triangle> triangles;
        for (const Face& face : m_faces)
            if (face.alive) triangles.push_back(face.corners);
        return triangles;
    }

private:
    /// Added to distances, this makes corners farther than the points between them, which are as far but for
    /// rounding: a strictly convex function is largest at a corner.
    double preferenceForCorners(Index point) const {
        return m_tolerance * m_points[point].squaredNorm() / (m_size * m_size);
    }

    /// The point that is farthest by some measure, if it is farther than the tolerance.
    template <typename Measure>
    bool farthest(Index& best, const Measure& measure) const {
        double largest = 0;
        for (Index i = 0; i < m_points.size(); ++i) {
            const double distance = measure(m_points[i]);
            if (!(distance > m_tolerance) || distance + preferenceForCorners(i) <= largest) continue;
            largest = distance + preferenceForCorners(i);
            best = i;
        }
        return largest > 0;
    }

    bool startWithTetrahedron() {
        Index a = 0, b = 0, c = 0, d = 0;
        const Vec3 start = m_points[0];
        if (!farthest(a, [&](const Vec3& p) { return (p - start).norm(); })) return false;
        const Vec3 pointA = m_points[a];
        if (!farthest(b, [&](const Vec3& p) { return (p - pointA).norm(); })) return false;
        const Vec3 line = (m_points[b] - pointA).normalized();
        if (!farthest(c, [&](const Vec3& p) { return line.cross(p - pointA).norm(); })) return false;
        const Vec3 normal = line.cross(m_points[c] - pointA).normalized();
        if (!farthest(d, [&](const Vec3& p) { return std::abs(normal.dot(p - pointA)); })) return false;
        if (height({a, b, c}, d) > 0) std::swap(b, c);

        m_faces = {{{a, b, c}, {1, 2, 3}, {}},
                   {{b, a, d}, {0, 3, 2}, {}},
                   {{c, b, d}, {0, 1, 3}, {}},
                   {{a, c, d}, {0, 2, 1}, {}}};
        std::vector<Index> all(m_points.size());
        for (Index i = 0; i < all.size(); ++i)
            all[i] = i;
        distribute(all, {0, 1, 2, 3});
        return true;
    }

    /// Above 0 outside the plane of a triangle, 0 in it, and without rounding: twice the area times the
    /// distance.
    double height(const Triangle& triangle, Index point) const {
        const Vec3& p = m_points[point];
        return exactDeterminant(m_points[triangle[0]] - p, m_points[triangle[2]] - p,
                                m_points[triangle[1]] - p);
    }

    double doubleArea(const Triangle& t) const {
        return (m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]).norm();
    }

    /// Gives each point to the one of some faces that it is farthest outside of.
    void distribute(const std::vector<Index>& points, const std::vector<Index>& faces) {
        std::vector<double> areas, farthest(faces.size(), 0);
        for (Index face : faces)
            areas.push_back(doubleArea(m_faces[face].corners));
        for (Index point : points) {
            double largest = m_tolerance;
            std::size_t owner = faces.size();
            for (std::size_t i = 0; i < faces.size(); ++i)
                if (const double distance = height(m_faces[faces[i]].corners, point) / areas[i];
                    distance > largest) {
                    largest = distance;
                    owner = i;
                }
            if (owner == faces.size()) continue;
            m_faces[faces[owner]].outside.push_back(point);
            farthest[owner] = std::max(farthest[owner], largest + preferenceForCorners(point));
        }
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (farthest[i] > 0) m_pending.push({farthest[i], faces[i]});
    }

    /// Replaces all faces that the farthest point of `face` sees by a fan from that point.
    void swallowFarthest(Index face) {
        const std::vector<Index>& outside = m_faces[face].outside;
        const double area = doubleArea(m_faces[face].corners);
        const auto distance = [&](Index point) {
            return height(m_faces[face].corners, point) / area + preferenceForCorners(point);
        };
        const Index eye = *std::max_element(outside.begin(), outside.end(),
                                            [&](Index i, Index j) { return distance(i) < distance(j); });
        std::vector<HorizonEdge> horizon;
        const std::vector<Index> orphans = removeVisible(face, eye, horizon);
        distribute(orphans, addFan(eye, horizon));
    }

    /// Faces in whose plane the eye lies stay: the fan goes on in their plane.
    std::vector<Index> removeVisible(Index seed, Index eye, std::vector<HorizonEdge>& horizon) {
        std::vector<Index> orphans, stack{seed};
        m_faces[seed].alive = false;
        while (!stack.empty()) {
            Face& face = m_faces[stack.back()];
            stack.pop_back();
            orphans.insert(orphans.end(), face.outside.begin(), face.outside.end());
            face.outside.clear();
            for (std::size_t side = 0; side < 3; ++side) {
                const Index next = face.neighbours[side];
                if (!m_faces[next].alive) continue;
                if (height(m_faces[next].corners, eye) > 0) {
                    m_faces[next].alive = false;
                    stack.push_back(next);
                } else {
                    horizon.push_back({face.corners[side], face.corners[(side + 1) % 3], next});
                }
            }
        }
        return orphans;
    }

    std::vector<Index> addFan(Index eye, const std::vector<HorizonEdge>& horizon) {
        std::unordered_map<Index, Index> faceFrom, faceTo;
        std::vector<Index> fan;
        for (const HorizonEdge& edge : horizon) {
            fan.push_back(Index(m_faces.size() + fan.size()));
            faceFrom[edge.from] = faceTo[edge.to] = fan.back();
        }
        assert(horizon.size() >= 3 && faceFrom.size() == horizon.size() && faceTo.size() == horizon.size());
        for (const HorizonEdge& edge : horizon) {
            Face& beyond = m_faces[edge.beyond];
            for (std::size_t side = 0; side < 3; ++side)
                if (beyond.corners[side] == edge.to) beyond.neighbours[side] = Index(m_faces.size());
            m_faces.push_back(
                {{edge.from, edge.to, eye}, {edge.beyond, faceFrom[edge.to], faceTo[edge.from]}, {}});
        }
        return fan;
    }

    std::vector<Vec3> m_points;
    double m_size, m_tolerance;
    std::vector<Face> m_faces;
    std::priority_queue<Pending> m_pending;
};

}  // namespace

TriangleMesh convexHull(const std::vector<Vec3>& points) {
    TriangleMesh mesh;
    std::unordered_map<Index, Index> newIndex;
    mesh.triangles = Quickhull(points).run();
    for (Triangle& triangle : mesh.triangles)
        for (Index& corner : triangle) {
            const auto [entry, isNew] = newIndex.try_emplace(corner, Index(mesh.vertices.size()));
            if (isNew) mesh.vertices.push_back(points[corner]);
            corner = entry->second;
        }
    return mesh;
}

}  // namespace bullet_buoyancy
