#include "bullet_buoyancy/hydrostatics/reference_patches.h"

#include <Eigen/Geometry>
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

    StepBounds alongStep(const Vec2& step) const override { return {along(step).squaredNorm(), 0}; }

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

    StepBounds alongStep(const Vec2& step) const override {
        const Vec2 squares = step.cwiseAbs2();
        return {squares.dot(m_lengthSquared), squares.dot(m_bend)};
    }

private:
    /// The derivatives of position are p' along the profile and the radius round the axis; the second ones
    /// p'', r' mixed and the radius. Profiles are so smooth that differences of 64 points find their largest
    /// values to a few hundredths. The mixed one counts half for each squared coordinate of a step, twice.
    void measure() {
        constexpr int points = 64;
        constexpr double margin = 1.1;
        const double h = (m_profile.end - m_profile.begin) / points;
        double length = 0, bend = 0, mixed = 0, radius = 0;
        for (int i = 1; i < points; ++i) {
            const double t = m_profile.begin + i * h;
            const ProfilePoint before = m_profile.at(t - h), here = m_profile.at(t),
                               after = m_profile.at(t + h);
            const double dr = (after.radius - before.radius) / (2 * h), dx = (after.x - before.x) / (2 * h);
            length = std::max(length, dx * dx + dr * dr);
            mixed = std::max(mixed, std::abs(dr));
            bend = std::max(bend, std::hypot(before.x - 2 * here.x + after.x,
                                             before.radius - 2 * here.radius + after.radius) /
                                      (h * h));
            radius = std::max({radius, before.radius, after.radius});
        }
        m_lengthSquared = margin * Vec2(length, radius * radius);
        m_bend = margin * Vec2(bend + mixed, radius + mixed);
    }

    Vec3 m_origin, m_axis, m_first, m_second;
    Profile m_profile;
    Vec2 m_lengthSquared, m_bend;  // for a unit step along either parameter
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
