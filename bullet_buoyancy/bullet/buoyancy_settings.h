#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// How the action takes the pressure of water that moves. Flat water presses alike whatever is set.
struct BuoyancySettings {
    PressureModel pressure = HydrostaticQuery().pressure;

    /// See HydrostaticQuery; finite and not below zero.
    double tolerance = HydrostaticQuery().tolerance;
};

}  // namespace bullet_buoyancy
