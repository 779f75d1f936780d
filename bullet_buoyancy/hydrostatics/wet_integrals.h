#pragma once

#include "bullet_buoyancy/hydrostatics/displacement.h"
#include "bullet_buoyancy/hydrostatics/hydrostatics.h"
#include "bullet_buoyancy/water/water_plane.h"

namespace bullet_buoyancy {

/// Integrals over the wet surface and over the displaced volume, in the body's frame about its origin, before
/// density and gravity. n is the outward normal, d the depth, h the head: d, but for waves whose pressure
/// decays.
struct WetIntegrals {
    Vec3 headNormal = Vec3::Zero();    ///< of h n over the surface, m^3
    Vec3 headTorque = Vec3::Zero();    ///< of x cross h n over the surface, m^4
    double volume = 0;                 ///< m^3
    Vec3 volumeMoment = Vec3::Zero();  ///< of x over the volume, m^4
    double headVolume = 0;             ///< of h over the volume, m^4
    double wettedArea = 0;             ///< m^2
    Waterplane waterplane;             ///< about the body's origin, in its axes
    Vec3 error = Vec3::Zero();         ///< upper bound of that of `headNormal`, by component, m^3
    Vec3 lastingError = Vec3::Zero();  ///< the same, which finer cells do not mend: at the waterline, m^3
    int samples = 0;                   ///< of the water

    /// A closed piece of the displacement: by Archimedes its pressure acts upward through its centre.
    void addDisplacement(const Vec3& up, const Displacement& piece) {
        headNormal -= piece.volume * up;
        headTorque -= piece.volumeMoment.cross(up);
        volume += piece.volume;
        volumeMoment += piece.volumeMoment;
        headVolume += piece.headVolume;
        error += piece.error * up.cwiseAbs();
    }

    /// A piece of the waterplane of given area, centre and second moment about that centre.
    void addWaterplane(double area, const Vec3& centre, const Mat3& centralSecondMoment) {
        waterplane.area += area;
        waterplane.firstMoment += area * centre;
        waterplane.secondMoment += area * centre * centre.transpose() + centralSecondMoment;
    }
};

/// From the body's frame to the world's axes, with the water's density and the query's gravity; adds the
/// stiffness if it is asked for. `pushesInBody`: minus the gradient of the head, the vertical in flat water.
HydrostaticResult toResult(const WetIntegrals& integrals, const Pose& pose, const WaterField& water,
                           const HydrostaticQuery& query, const Vec3& pushesInBody);

/// The same of a displacement alone, in flat water, without extras.
HydrostaticResult toResult(const Displacement& displaced, const Pose& pose, const WaterField& water,
                           const HydrostaticQuery& query);

}  // namespace bullet_buoyancy
