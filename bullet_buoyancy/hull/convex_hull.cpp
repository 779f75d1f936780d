#include "bullet_buoyancy/hull/convex_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/hull/mesh_repair.h"

namespace bullet_buoyancy {

namespace {

using Index = std::uint32_t;

struct Face {
    Triangle corners;
    std::array<Index, 3> neighbours;  // across the side from corner i to corner i + 1
    Vec3 normal;
    double offset;
    std::vector<Index> outside;  // points that only this face is asked to swallow
    bool alive = true;

    double distance(const Vec3& point) const { return normal.dot(point) - offset; }
};

struct HorizonEdge {
    Index from, to;
    Index beyond;  // the face that stays
};

class Quickhull {
public:
    Quickhull(const std::vector<Vec3>& points, double tolerance) : m_points(points), m_tolerance(tolerance) {}

    TriangleMesh run() {
        if (!startWithTetrahedron()) return {};
        for (Index face = 0; face < m_faces.size(); ++face)
            while (m_faces[face].alive && !m_faces[face].outside.empty())
                if (!swallowFarthest(face)) return {};
        return result();
    }

private:
    /// The farthest point by some measure, if it is above the tolerance.
    template <typename Measure>
    bool farthest(Index& best, const Measure& measure) const {
        double largest = m_tolerance;
        bool found = false;
        for (Index i = 0; i < m_points.size(); ++i)
            if (const double value = measure(m_points[i]); value > largest) {
                largest = value;
                best = i;
                found = true;
            }
        return found;
    }

    bool startWithTetrahedron() {
        Index a = 0, b = 0, c = 0, d = 0;
        const Vec3 start = m_points.empty() ? Vec3::Zero() : m_points[0];
        if (!farthest(a, [&](const Vec3& p) { return (p - start).norm(); })) return false;
        if (!farthest(b, [&](const Vec3& p) { return (p - m_points[a]).norm(); })) return false;
        const Vec3 line = (m_points[b] - m_points[a]).normalized();
        if (!farthest(c, [&](const Vec3& p) { return line.cross(p - m_points[a]).norm(); })) return false;
        const Vec3 normal = line.cross(m_points[c] - m_points[a]).normalized();
        if (!farthest(d, [&](const Vec3& p) { return std::abs(normal.dot(p - m_points[a])); })) return false;
        if (normal.dot(m_points[d] - m_points[a]) > 0) std::swap(b, c);

        addFace({a, b, c}, {1, 2, 3});
        addFace({b, a, d}, {0, 3, 2});
        addFace({c, b, d}, {0, 1, 3});
        addFace({a, c, d}, {0, 2, 1});
        std::vector<Index> all(m_points.size());
        for (Index i = 0; i < all.size(); ++i)
            all[i] = i;
        distribute(all, 0);
        return true;
    }

    void addFace(const Triangle& corners, const std::array<Index, 3>& neighbours) {
        const Vec3& a = m_points[corners[0]];
        const Vec3 normal = (m_points[corners[1]] - a).cross(m_points[corners[2]] - a).normalized();
        m_faces.push_back({corners, neighbours, normal, normal.dot(a), {}});
    }

    /// Gives each point to the face from `firstFace` on that it is farthest outside of.
    void distribute(const std::vector<Index>& points, Index firstFace) {
        for (Index point : points) {
            double largest = m_tolerance;
            Face* owner = nullptr;
            for (Index face = firstFace; face < m_faces.size(); ++face)
                if (const double distance = m_faces[face].distance(m_points[point]); distance > largest) {
                    largest = distance;
                    owner = &m_faces[face];
                }
            if (owner) owner->outside.push_back(point);
        }
    }

    /// Replaces all faces that the farthest point of `face` sees by a fan from that point. False if rounding
    /// has torn the horizon.
    bool swallowFarthest(Index face) {
        const std::vector<Index>& outside = m_faces[face].outside;
        const Index eye = *std::max_element(outside.begin(), outside.end(), [&](Index i, Index j) {
            return m_faces[face].distance(m_points[i]) < m_faces[face].distance(m_points[j]);
        });
        std::vector<HorizonEdge> horizon;
        const std::vector<Index> orphans = removeVisible(face, eye, horizon);
        const auto firstNew = Index(m_faces.size());
        if (!addFan(eye, horizon)) return false;
        distribute(orphans, firstNew);
        return true;
    }

    /// Faces in whose plane the eye lies count as visible: the fan then has no slivers along flat faces.
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
                if (m_faces[next].distance(m_points[eye]) > -m_tolerance) {
                    m_faces[next].alive = false;
                    stack.push_back(next);
                } else {
                    horizon.push_back({face.corners[side], face.corners[(side + 1) % 3], next});
                }
            }
        }
        return orphans;
    }

    bool addFan(Index eye, const std::vector<HorizonEdge>& horizon) {
        std::unordered_map<Index, Index> faceFrom, faceTo;
        const auto firstNew = Index(m_faces.size());
        for (Index i = 0; i < horizon.size(); ++i) {
            faceFrom[horizon[i].from] = firstNew + i;
            faceTo[horizon[i].to] = firstNew + i;
        }
        if (horizon.size() < 3 || faceFrom.size() != horizon.size() || faceTo.size() != horizon.size())
            return false;
        for (const HorizonEdge& edge : horizon) {
            const auto here = Index(m_faces.size());
            if (!faceFrom.count(edge.to) || !faceTo.count(edge.from)) return false;
            addFace({edge.from, edge.to, eye}, {edge.beyond, faceFrom[edge.to], faceTo[edge.from]});
            Face& beyond = m_faces[edge.beyond];
            for (std::size_t side = 0; side < 3; ++side)
                if (beyond.corners[side] == edge.to) beyond.neighbours[side] = here;
        }
        return true;
    }

    TriangleMesh result() const {
        TriangleMesh mesh;
        std::unordered_map<Index, Index> newIndex;
        for (const Face& face : m_faces) {
            if (!face.alive) continue;
            Triangle triangle{};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [entry, isNew] =
                    newIndex.try_emplace(face.corners[i], Index(mesh.vertices.size()));
                if (isNew) mesh.vertices.push_back(m_points[face.corners[i]]);
                triangle[i] = entry->second;
            }
            mesh.triangles.push_back(triangle);
        }
        return mesh;
    }

    const std::vector<Vec3>& m_points;
    double m_tolerance;
    std::vector<Face> m_faces;
};

}  // namespace

TriangleMesh convexHull(const std::vector<Vec3>& points) {
    return Quickhull(points, convexHullTolerance * meshSize({points, {}})).run();
}

}  // namespace bullet_buoyancy
