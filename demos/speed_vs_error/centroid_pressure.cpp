#include "speed_vs_error/centroid_pressure.h"

#include <limits>

#include "scenes/study_hulls.h"
#include "speed_vs_error/point_depths.h"

namespace bullet_buoyancy::demo {

namespace {

using Eigen::Vector3f;

std::vector<Vec3> centroidsOf(const TriangleMesh& mesh) {
    std::vector<Vec3> centroids;
    for (const Triangle& t : mesh.triangles)
        centroids.push_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
    return centroids;
}

class CentroidPressure final : public ReadyEvaluator {
public:
    CentroidPressure(const TriangleMesh& mesh, const WaterField& water)
        : m_depths(centroidsOf(mesh), water), m_density(float(water.density())) {
        const std::vector<Vec3> centroids = centroidsOf(mesh);
        for (std::size_t i = 0; i < centroids.size(); ++i) {
            const Triangle& t = mesh.triangles[i];
            const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
            const Vec3 area = (b - a).cross(c - a) / 2;
            m_faces.push_back({area.cast<float>(), centroids[i].cross(area).cast<float>()});
        }
    }

    Wrench evaluate(const Pose& pose, const HydrostaticQuery& query) override {
        const FloatPose at(pose);
        const Eigen::ArrayXf& depths = m_depths.at(at, query.time);
        Vector3f force = Vector3f::Zero(), torque = Vector3f::Zero();
        for (std::size_t i = 0; i < m_faces.size(); ++i) {
            const float depth = std::max(0.0f, depths[Eigen::Index(i)]);
            force -= depth * m_faces[i].area;
            torque -= depth * m_faces[i].moment;
        }
        const float weight = m_density * float(query.gravity);
        return {(weight * (at.worldFromBody * force)).cast<double>(),
                (weight * (at.worldFromBody * torque)).cast<double>(),
                std::numeric_limits<double>::infinity()};
    }

private:
    struct Face {
        Vector3f area;    ///< outward, m^2
        Vector3f moment;  ///< its centroid cross that, m^3
    };

    PointDepths m_depths;
    std::vector<Face> m_faces;
    float m_density;
};

}  // namespace

std::unique_ptr<ReadyEvaluator> pressCentroids(const Hull& hull, const WaterField& water) {
    return std::make_unique<CentroidPressure>(scenes::asMesh(hull), water);
}

}  // namespace bullet_buoyancy::demo
