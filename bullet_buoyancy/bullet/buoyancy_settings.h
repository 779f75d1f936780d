#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// How the action takes the pressure of the water.
struct BuoyancySettings {
    /// In waves; the same in flat water.
    PressureModel pressure = HydrostaticQuery().pressure;

    /// Error of the force that waves may cause, over the weight of water that the whole hull displaces; 0:
    /// every vertex asks the water. See HydrostaticQuery; finite and not below zero.
    double tolerance = HydrostaticQuery().tolerance;

    /// Of the sums over triangles, in flat water as well. Single precision is a tenth faster on a crate,
    /// twice as fast on large meshes; the water's potential is then right to some 1e-7 only, and the energy
    /// with it.
    Precision precision = HydrostaticQuery().precision;
};

}  // namespace bullet_buoyancy
