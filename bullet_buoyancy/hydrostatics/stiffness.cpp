#include "bullet_buoyancy/hydrostatics/stiffness.h"

#include <Eigen/Geometry>

namespace bullet_buoyancy {

Mat6 hydrostaticStiffness(const HydrostaticResult& result, const Vec3& upWorld, double weightDensity) {
    const Waterplane& waterplane = result.waterplane;
    const Vec3 momentArm = waterplane.firstMoment.cross(upWorld);  // integral of r x n
    Mat3 crossUp;                                                  // crossUp r = r x n
    crossUp << 0, upWorld.z(), -upWorld.y(),                       //
        -upWorld.z(), 0, upWorld.x(),                              //
        upWorld.y(), -upWorld.x(), 0;
    const Vec3& centre = result.centreOfBuoyancyFromCom;
    const Mat3 ofCentre =
        result.submergedVolume * (centre.dot(upWorld) * Mat3::Identity() - centre * upWorld.transpose());

    Mat6 stiffness;
    stiffness.topLeftCorner<3, 3>() = waterplane.area * upWorld * upWorld.transpose();
    stiffness.topRightCorner<3, 3>() = upWorld * momentArm.transpose();
    stiffness.bottomLeftCorner<3, 3>() = momentArm * upWorld.transpose();
    stiffness.bottomRightCorner<3, 3>() = crossUp * waterplane.secondMoment * crossUp.transpose() + ofCentre;
    return weightDensity * stiffness;
}

}  // namespace bullet_buoyancy
