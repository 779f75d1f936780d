#pragma once

namespace bullet_buoyancy {

/// How pressure grows from the surface of waves down.
enum class PressureModel {
    hydrostatic,  ///< by rho g a metre, under the instantaneous surface
    waveDynamic,  ///< that of the undisturbed waves (Froude-Krylov): their part decays with depth
};

}  // namespace bullet_buoyancy
