#include "boat_in_waves/profile.h"

#include <algorithm>

namespace bullet_buoyancy::demo {

namespace {

bool turnsLeft(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 ab = b - a, bc = c - b;
    return ab.x() * bc.y() - ab.y() * bc.x() > 0;
}

void extend(std::vector<Vec2>& chain, std::size_t start, const Vec2& point) {
    while (chain.size() >= start + 2 && !turnsLeft(chain[chain.size() - 2], chain.back(), point))
        chain.pop_back();
    chain.push_back(point);
}

}  // namespace

/// The monotone chain of Andrew (1979).
std::vector<Vec2> profileOf(const TriangleMesh& mesh) {
    std::vector<Vec2> points;
    for (const Vec3& vertex : mesh.vertices)
        points.emplace_back(vertex.x(), vertex.z());
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Vec2> chain;
    for (const Vec2& point : points)
        extend(chain, 0, point);
    const std::size_t top = chain.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
        extend(chain, top, *point);
    chain.pop_back();
    return chain;
}

/// Clipped as by Sutherland and Hodgman (1974).
std::vector<Vec2> below(const std::vector<Vec2>& outline, double height) {
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if (a.y() <= height) result.push_back(a);
        if ((a.y() < height && b.y() > height) || (a.y() > height && b.y() < height))
            result.push_back(a + (height - a.y()) / (b.y() - a.y()) * (b - a));
    }
    return result;
}

}  // namespace bullet_buoyancy::demo
