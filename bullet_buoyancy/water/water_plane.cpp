#include "bullet_buoyancy/water/water_plane.h"

#include <array>
#include <cassert>

namespace bullet_buoyancy {

WaterPlane waterPlaneInBody(const WaterField& water, const Pose& pose, double time) {
    assert(water.bounds().isFlat());
    const Vec3 position = water.frame().pointFromWorld(pose.position);
    std::array<double, 3> sample{};
    water.sampleSurface(Eigen::Map<const Eigen::ArrayX2d>(position.data(), 1, 2), time,
                        Eigen::Map<Eigen::ArrayX3d>(sample.data(), 1, 3));
    return {pose.orientation.conjugate() * water.frame().upWorld(), sample[0] - position.z()};
}

}  // namespace bullet_buoyancy
