#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// How the action takes the pressure of the water.
struct BuoyancySettings {
    PressureModel pressure = HydrostaticQuery().pressure;

    /// See HydrostaticQuery; finite and not below zero.
    double tolerance = HydrostaticQuery().tolerance;

    /// Of the sums over triangles, in flat water as well. Single precision is a fifth faster on a crate,
    /// twice as fast on large meshes; the water's potential is then right to some 1e-7 only, and the energy
    /// with it.
    Precision precision = HydrostaticQuery().precision;
};

}  // namespace bullet_buoyancy
