#include "bullet_buoyancy/water/water_plane.h"

#include <array>
#include <cassert>

namespace bullet_buoyancy {

WaterPlane waterPlaneInBody(const WaterField& water, const Pose& pose, double time) {
    const WaterBounds bounds = water.bounds();
    assert(bounds.isFlat());
    const Vec3 upInBody = pose.orientation.conjugate() * water.frame().upWorld();
    const Vec3 position = water.frame().pointFromWorld(pose.position);
    if (bounds.isLevel()) return {upInBody, -position.z()};
    std::array<double, 3> sample{};
    water.sampleSurface(Eigen::Map<const Eigen::ArrayX2d>(position.data(), 1, 2), time,
                        Eigen::Map<Eigen::ArrayX3d>(sample.data(), 1, 3));
    return {upInBody, sample[0] - position.z()};
}

}  // namespace bullet_buoyancy
