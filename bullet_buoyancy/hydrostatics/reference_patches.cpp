#include "bullet_buoyancy/hydrostatics/reference_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

namespace {

class FlatTriangle final : public SurfacePatch {
public:
    FlatTriangle(const Vec3& a, const Vec3& b, const Vec3& c) : m_corner(a), m_ab(b - a), m_ac(c - a) {}

    std::vector<ParameterTriangle> domain() const override { return {{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}}; }

    PatchPoint at(const Vec2& p) const override { return {m_corner + along(p), m_ab.cross(m_ac)}; }

    StepBounds alongStep(const ParameterTriangle&, const Vec2& step) const override {
        return {along(step).squaredNorm(), 0};
    }

private:
    Vec3 along(const Vec2& step) const { return step.x() * m_ab + step.y() * m_ac; }

    Vec3 m_corner, m_ab, m_ac;
};

/// A point of the curve that is turned about the axis, and its derivatives by the curve's parameter.
struct ProfilePoint {
    double x, radius;
    double dx;                ///< of x
    double radiusTimesSlope;  ///< radius times the derivative of radius
};

struct Profile {
    double begin, end;
    std::function<ProfilePoint(double)> at;
};

/// x = middle + half * sin(t): the radius is smooth in t even at a pole, where it goes like a square root in
/// x.
Profile sideProfile(const ProfilePiece& piece) {
    return {-pi / 2, pi / 2, [piece](double t) {
                const double half = (piece.end - piece.begin) / 2;
                const double x = (piece.begin + piece.end) / 2 + half * std::sin(t), dx = half * std::cos(t);
                return ProfilePoint{x, std::sqrt(std::max(0.0, piece.radiusSquared(x))), dx,
                                    (piece.c1 / 2 + x * piece.c2) * dx};
            }};
}

/// A flat end. Outward is along the axis where the radius falls.
Profile discProfile(double x, double from, double to) {
    return {0, 1, [x, from, to](double t) {
                const double radius = from + t * (to - from);
                return ProfilePoint{x, radius, 0, radius * (to - from)};
            }};
}

/// A profile turned about the axis: the parameters are the profile's and the angle.
class Revolved final : public SurfacePatch {
public:
    Revolved(const SolidOfRevolution& solid, Profile profile)
        : m_origin(solid.origin),
          m_axis(solid.axis),
          m_first(solid.axis.unitOrthogonal()),
          m_second(solid.axis.cross(m_first)),
          m_profile(std::move(profile)) {
        measure();
    }

    std::vector<ParameterTriangle> domain() const override {
        constexpr int columns = 2, rows = 4;
        std::vector<ParameterTriangle> triangles;
        const Vec2 step((m_profile.end - m_profile.begin) / columns, 2 * pi / rows);
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < rows; ++j) {
                const Vec2 low = Vec2(m_profile.begin, 0) + step.cwiseProduct(Vec2(i, j)), high = low + step;
                triangles.push_back({low, Vec2(high.x(), low.y()), high});
                triangles.push_back({low, high, Vec2(low.x(), high.y())});
            }
        return triangles;
    }

    PatchPoint at(const Vec2& parameters) const override {
        const ProfilePoint p = m_profile.at(parameters.x());
        const Vec3 outward = std::cos(parameters.y()) * m_first + std::sin(parameters.y()) * m_second;
        return {m_origin + p.x * m_axis + p.radius * outward,
                p.radius * p.dx * outward - p.radiusTimesSlope * m_axis};
    }

    /// The second derivative of position is p'' step.x^2 - radius step.y^2 in the plane of the axis and 2 r'
    /// step.x step.y across it, with p = (x, r) along the profile. With `extra` added to the factors of the
    /// squares, their sum is above the hypotenuse of both.
    StepBounds alongStep(const ParameterTriangle& cell, const Vec2& step) const override {
        const Stretch s = stretchOver(cell);
        const double sum = s.bend + s.radius;
        const double extra = (std::sqrt(sum * sum + 8 * s.lengthSquared) - sum) / 2;
        const Vec2 squares = step.cwiseAbs2();
        return {squares.dot(Vec2(s.lengthSquared, s.radius * s.radius)),
                squares.dot(Vec2(s.bend + extra, s.radius + extra))};
    }

private:
    /// Largest values over a stretch of the profile: of its radius, its squared first derivative and its
    /// second one.
    struct Stretch {
        double radius = 0, lengthSquared = 0, bend = 0;
    };

    /// By differences between points so dense that profiles, which are smooth, do not change by more than the
    /// margin in between.
    void measure() {
        const double h = (m_profile.end - m_profile.begin) / stretches;
        for (int i = 0; i <= stretches; ++i) {
            const double t = m_profile.begin + std::clamp(i, 1, stretches - 1) * h;
            const ProfilePoint before = m_profile.at(t - h), here = m_profile.at(t),
                               after = m_profile.at(t + h);
            const double dr = (after.radius - before.radius) / (2 * h), dx = (after.x - before.x) / (2 * h);
            const double bend =
                std::hypot(before.x - 2 * here.x + after.x, before.radius - 2 * here.radius + after.radius);
            m_samples[std::size_t(i)] = {m_profile.at(m_profile.begin + i * h).radius, dx * dx + dr * dr,
                                         bend / (h * h)};
        }
    }

    Stretch stretchOver(const ParameterTriangle& cell) const {
        const auto [first, last] = std::minmax({cell[0].x(), cell[1].x(), cell[2].x()});
        const auto index = [&](double t) {
            return (t - m_profile.begin) / (m_profile.end - m_profile.begin) * stretches;
        };
        const int from = std::max(0, int(std::floor(index(first))) - 1);
        const int to = std::min(stretches, int(std::ceil(index(last))) + 1);
        Stretch most;
        for (int i = from; i <= to; ++i) {
            const Stretch& sample = m_samples[std::size_t(i)];
            most.radius = std::max(most.radius, sample.radius);
            most.lengthSquared = std::max(most.lengthSquared, sample.lengthSquared);
            most.bend = std::max(most.bend, sample.bend);
        }
        constexpr double margin = 1.02;
        return {margin * most.radius, margin * most.lengthSquared, margin * most.bend};
    }

    static constexpr int stretches = 64;

    Vec3 m_origin, m_axis, m_first, m_second;
    Profile m_profile;
    std::array<Stretch, stretches + 1> m_samples;
};

using Patches = std::vector<std::unique_ptr<const SurfacePatch>>;

void addPatches(const SolidOfRevolution& solid, Patches& patches) {
    const auto add = [&](Profile profile) {
        patches.push_back(std::make_unique<Revolved>(solid, std::move(profile)));
    };
    for (const ProfilePiece& piece : solid.profile)
        add(sideProfile(piece));
    const ProfilePiece &first = solid.profile.front(), &last = solid.profile.back();
    const double begins = first.radiusSquared(first.begin), ends = last.radiusSquared(last.end);
    if (begins > 0) add(discProfile(first.begin, 0, std::sqrt(begins)));
    if (ends > 0) add(discProfile(last.end, std::sqrt(ends), 0));
}

}  // namespace

Patches patchesOf(const Hull& hull) {
    Patches patches;
    const std::vector<Vec3>& vertices = hull.mesh.vertices;
    for (const Triangle& t : hull.mesh.triangles)
        patches.push_back(std::make_unique<FlatTriangle>(vertices[t[0]], vertices[t[1]], vertices[t[2]]));
    for (const Sphere& sphere : hull.spheres)
        addPatches(asSolidOfRevolution(sphere), patches);
    for (const SolidOfRevolution& solid : hull.solids)
        addPatches(solid, patches);
    return patches;
}

}  // namespace bullet_buoyancy
