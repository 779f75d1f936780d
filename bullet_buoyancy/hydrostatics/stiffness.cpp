#include "bullet_buoyancy/hydrostatics/stiffness.h"

#include <Eigen/Geometry>

namespace bullet_buoyancy {

Mat6 hydrostaticStiffness(const HydrostaticResult& result, const Vec3& pushesWorld, double weightDensity) {
    const Waterplane& waterplane = result.waterplane;
    const Vec3 momentArm = waterplane.firstMoment.cross(pushesWorld);  // integral of r x n
    Mat3 crossUp;                                                      // crossUp r = r x n
    crossUp << 0, pushesWorld.z(), -pushesWorld.y(),                   //
        -pushesWorld.z(), 0, pushesWorld.x(),                          //
        pushesWorld.y(), -pushesWorld.x(), 0;
    const Vec3& centre = result.centreOfBuoyancyFromCom;
    const Mat3 ofCentre = result.submergedVolume *
                          (centre.dot(pushesWorld) * Mat3::Identity() - centre * pushesWorld.transpose());

    Mat6 stiffness;
    stiffness.topLeftCorner<3, 3>() = waterplane.area * pushesWorld * pushesWorld.transpose();
    stiffness.topRightCorner<3, 3>() = pushesWorld * momentArm.transpose();
    stiffness.bottomLeftCorner<3, 3>() = momentArm * pushesWorld.transpose();
    stiffness.bottomRightCorner<3, 3>() = crossUp * waterplane.secondMoment * crossUp.transpose() + ofCentre;
    return weightDensity * stiffness;
}

}  // namespace bullet_buoyancy
