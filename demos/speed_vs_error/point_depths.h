#pragma once

#include <vector>

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::demo {

/// A pose as an engine in single precision has it.
struct FloatPose {
    Eigen::Matrix3f worldFromBody;
    Eigen::Vector3f position;

    explicit FloatPose(const Pose& pose)
        : worldFromBody(pose.orientation.cast<float>().toRotationMatrix()),
          position(pose.position.cast<float>()) {}
};

/// How deep points of a body are below the surface, straight down, in single precision. The world's axes are
/// the water's: z up. Flat water needs no samples; in waves the water is asked over every point.
class PointDepths {
public:
    /// Points in the body's frame, m.
    PointDepths(const std::vector<Vec3>& points, const WaterField& water);

    /// m, above zero under water; valid until the next call.
    const Eigen::ArrayXf& at(const FloatPose& pose, double time);

private:
    void sampleElevations(const FloatPose& pose, double time);

    Eigen::ArrayX3f m_points;
    Eigen::ArrayXf m_depths;
    Eigen::ArrayX2d m_places;
    Eigen::ArrayX3d m_surface;
    const WaterField& m_water;
    bool m_isFlat;
};

}  // namespace bullet_buoyancy::demo
