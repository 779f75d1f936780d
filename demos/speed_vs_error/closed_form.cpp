#include "speed_vs_error/closed_form.h"

#include <limits>

#include "scenes/study_hulls.h"
#include "speed_vs_error/point_depths.h"

namespace bullet_buoyancy::demo {

namespace {

using Eigen::Vector3f;

struct Corner {
    Vector3f position;
    float depth;
};

Corner cut(const Corner& wet, const Corner& dry) {
    const float fraction = wet.depth / (wet.depth - dry.depth);
    return {wet.position + fraction * (dry.position - wet.position), 0};
}

/// Integrals of depth over the wet surface, in the body's frame.
struct Sums {
    Vector3f sixForces = Vector3f::Zero(), torques24 = Vector3f::Zero();

    void addWet(const Corner& a, const Corner& b, const Corner& c) {
        const Vector3f twiceArea = (b.position - a.position).cross(c.position - a.position);
        const float depth = a.depth + b.depth + c.depth;
        const Vector3f moment =
            (depth + a.depth) * a.position + (depth + b.depth) * b.position + (depth + c.depth) * c.position;
        sixForces -= depth * twiceArea;
        torques24 -= moment.cross(twiceArea);
    }

    void addOneWet(const Corner& wet, const Corner& next, const Corner& last) {
        addWet(wet, cut(wet, next), cut(wet, last));
    }

    void addOneDry(const Corner& dry, const Corner& next, const Corner& last) {
        const Corner entering = cut(next, dry), leaving = cut(last, dry);
        addWet(entering, next, last);
        addWet(entering, last, leaving);
    }

    void add(const Corner& a, const Corner& b, const Corner& c) {
        const bool wetA = a.depth > 0, wetB = b.depth > 0, wetC = c.depth > 0;
        const int wet = wetA + wetB + wetC;
        if (wet == 0) return;
        if (wet == 3) return addWet(a, b, c);
        if (wet == 1) return wetA ? addOneWet(a, b, c) : wetB ? addOneWet(b, c, a) : addOneWet(c, a, b);
        return !wetA ? addOneDry(a, b, c) : !wetB ? addOneDry(b, c, a) : addOneDry(c, a, b);
    }
};

class ClosedForm final : public ReadyEvaluator {
public:
    ClosedForm(const TriangleMesh& mesh, const WaterField& water)
        : m_triangles(mesh.triangles), m_depths(mesh.vertices, water), m_density(float(water.density())) {
        for (const Vec3& vertex : mesh.vertices)
            m_vertices.push_back(vertex.cast<float>());
    }

    Wrench evaluate(const Pose& pose, const HydrostaticQuery& query) override {
        const FloatPose at(pose);
        const Eigen::ArrayXf& depths = m_depths.at(at, query.time);
        const auto corner = [&](std::uint32_t i) { return Corner{m_vertices[i], depths[Eigen::Index(i)]}; };
        Sums sums;
        for (const Triangle& t : m_triangles)
            sums.add(corner(t[0]), corner(t[1]), corner(t[2]));
        const float weight = m_density * float(query.gravity);
        return {(weight / 6 * (at.worldFromBody * sums.sixForces)).cast<double>(),
                (weight / 24 * (at.worldFromBody * sums.torques24)).cast<double>(),
                std::numeric_limits<double>::infinity()};
    }

private:
    std::vector<Vector3f> m_vertices;
    std::vector<Triangle> m_triangles;
    PointDepths m_depths;
    float m_density;
};

}  // namespace

std::unique_ptr<ReadyEvaluator> closedFormInFloat(const Hull& hull, const WaterField& water) {
    return std::make_unique<ClosedForm>(scenes::asMesh(hull), water);
}

}  // namespace bullet_buoyancy::demo
