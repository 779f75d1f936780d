#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

WetIntegrals& WetIntegrals::operator+=(const WetIntegrals& other) {
    depthNormal += other.depthNormal;
    depthTorque += other.depthTorque;
    volume += other.volume;
    volumeMoment += other.volumeMoment;
    depthVolume += other.depthVolume;
    wettedArea += other.wettedArea;
    waterplane.area += other.waterplane.area;
    waterplane.firstMoment += other.waterplane.firstMoment;
    waterplane.secondMoment += other.waterplane.secondMoment;
    return *this;
}

HydrostaticResult toResult(const WetIntegrals& integrals, const Pose& pose, double density, double gravity) {
    const Mat3 rotation = pose.worldFromBody();
    const double weightDensity = density * gravity;
    HydrostaticResult result;
    result.forceWorld = -weightDensity * (rotation * integrals.depthNormal);
    result.torqueAboutCom = -weightDensity * (rotation * integrals.depthTorque);
    result.submergedVolume = integrals.volume;
    if (integrals.volume != 0)
        result.centreOfBuoyancyFromCom = rotation * (integrals.volumeMoment / integrals.volume);
    result.potentialEnergy = weightDensity * integrals.depthVolume;
    result.wettedArea = integrals.wettedArea;
    result.waterplane.area = integrals.waterplane.area;
    result.waterplane.firstMoment = rotation * integrals.waterplane.firstMoment;
    result.waterplane.secondMoment = rotation * integrals.waterplane.secondMoment * rotation.transpose();
    return result;
}

}  // namespace bullet_buoyancy
