#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

#include "bullet_buoyancy/hydrostatics/stiffness.h"

namespace bullet_buoyancy {

HydrostaticResult toResult(const WetIntegrals& integrals, const Pose& pose, const WaterField& water,
                           const HydrostaticQuery& query, const Vec3& pushesInBody) {
    const Mat3 rotation = pose.worldFromBody();
    const double weightDensity = water.density() * query.gravity;
    HydrostaticResult result;
    result.forceWorld = -weightDensity * (rotation * integrals.headNormal);
    result.torqueAboutCom = -weightDensity * (rotation * integrals.headTorque);
    result.submergedVolume = integrals.volume;
    if (integrals.volume != 0)
        result.centreOfBuoyancyFromCom = rotation * (integrals.volumeMoment / integrals.volume);
    result.potentialEnergy = weightDensity * integrals.headVolume;
    result.forceErrorBound = weightDensity * (integrals.error + integrals.lastingError).norm();
    result.waterSamples = integrals.samples;
    result.wettedArea = integrals.wettedArea;
    if (query.needsWaterplane()) {
        result.waterplane.area = integrals.waterplane.area;
        result.waterplane.firstMoment = rotation * integrals.waterplane.firstMoment;
        result.waterplane.secondMoment = rotation * integrals.waterplane.secondMoment * rotation.transpose();
    }
    if (query.stiffness)
        result.stiffness = hydrostaticStiffness(result, rotation * pushesInBody, weightDensity);
    return result;
}

HydrostaticResult toResult(const Displacement& displaced, const Pose& pose, const WaterField& water,
                           const HydrostaticQuery& query) {
    const double weightDensity = water.density() * query.gravity;
    HydrostaticResult result;
    const Vec3 up = water.frame().upWorld(), moment = pose.orientation * displaced.volumeMoment;
    result.forceWorld = weightDensity * displaced.volume * up;
    result.torqueAboutCom = weightDensity * moment.cross(up);
    result.submergedVolume = displaced.volume;
    if (displaced.volume != 0) result.centreOfBuoyancyFromCom = moment / displaced.volume;
    result.potentialEnergy = weightDensity * displaced.headVolume;
    result.forceErrorBound = weightDensity * displaced.error;
    return result;
}

}  // namespace bullet_buoyancy
