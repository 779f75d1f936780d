#include "bullet_buoyancy/water/water_frame.h"

#include <Eigen/Geometry>
#include <cassert>

namespace bullet_buoyancy {

WaterFrame WaterFrame::yUp(const Vec3& originWorld) {
    Mat3 axes;
    axes << 1, 0, 0,  //
        0, 0, 1,      //
        0, -1, 0;
    return {originWorld, axes};
}

WaterFrame WaterFrame::zUp(const Vec3& originWorld) {
    return {originWorld, Mat3::Identity()};
}

WaterFrame WaterFrame::fromUp(const Vec3& originWorld, const Vec3& upWorld) {
    assert(upWorld.allFinite() && upWorld.norm() > 0);
    const Vec3 up = upWorld.normalized();
    Eigen::Index leastVertical = 0;
    up.cwiseAbs().minCoeff(&leastVertical);
    Mat3 axes;
    axes.col(2) = up;
    axes.col(1) = up.cross(Vec3::Unit(leastVertical)).normalized();
    axes.col(0) = axes.col(1).cross(up);
    return {originWorld, axes};
}

}  // namespace bullet_buoyancy
