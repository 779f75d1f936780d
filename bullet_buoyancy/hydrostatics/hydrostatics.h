#pragma once

#include <optional>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/water/pressure_model.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// How triangles are summed up by those evaluators that know both.
enum class Precision {
    single,  ///< the force is right to 2e-6 of the weight of water that a compact hull displaces, see the
             ///< bound
    full,    ///< to 1e-12
};

/// What to evaluate. The extras cost only where asked for.
struct HydrostaticQuery {
    double gravity = standardGravity;                     ///< along the water frame's down, m/s^2
    double time = 0;                                      ///< s, for water that moves
    PressureModel pressure = PressureModel::hydrostatic;  ///< in waves; the same in flat water

    /// Error of the force that waves may cause, over the weight of water that the whole hull displaces. 0:
    /// the surface is sampled at every vertex of the mesh, and taken for linear in between. Flat water is
    /// exact.
    double tolerance = 1e-3;

    Precision precision = Precision::full;  ///< where triangles are summed up under a plane of water

    bool wettedArea = false;  ///< extra: of the hull's surface under water
    bool waterplane = false;  ///< extra: area and moments of the section at the surface
    bool stiffness = false;   ///< extra: how force and torque answer to a displacement

    /// For itself, or for the stiffness.
    bool needsWaterplane() const { return waterplane || stiffness; }
};

/// The section of a body at the water's surface; r runs from the centre of mass, in world axes.
/// Defined by -integral of (..) n_up over the wet surface: for an open mesh that is not the section.
struct Waterplane {
    double area = 0;                   ///< m^2
    Vec3 firstMoment = Vec3::Zero();   ///< integral of r, m^3
    Mat3 secondMoment = Mat3::Zero();  ///< integral of r r^T, m^4
};

/// What the pressure of the water does to a body. Pressure is gauge pressure: zero at the surface, no air.
struct HydrostaticResult {
    Vec3 forceWorld = Vec3::Zero();               ///< N
    Vec3 torqueAboutCom = Vec3::Zero();           ///< world axes, N m
    double submergedVolume = 0;                   ///< displacement, m^3
    Vec3 centreOfBuoyancyFromCom = Vec3::Zero();  ///< world axes, m; zero where nothing is displaced
    double potentialEnergy = 0;  ///< rho g times the integral of depth over the displacement, J
    /// The force is no farther than this from that of the true surface, N: proved for meshes, for round
    /// solids with constants of their quadrature that were tried in some ten thousand cases.
    double forceErrorBound = 0;
    int waterSamples = 0;   ///< points at which the water was asked for its surface or head
    double wettedArea = 0;  ///< m^2, if asked for
    Waterplane waterplane;  ///< if asked for

    /// If asked for: the change of (force, torque) is -stiffness times (displacement in m, rotation about the
    /// centre of mass in rad), world axes; see `hydrostaticStiffness`.
    std::optional<Mat6> stiffness;
};

}  // namespace bullet_buoyancy
