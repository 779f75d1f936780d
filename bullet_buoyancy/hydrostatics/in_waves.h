#pragma once

#include "bullet_buoyancy/hydrostatics/mesh_sum.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"

namespace bullet_buoyancy {

/// Adds what water with waves does to a hull, with the bound of the error that the waves cause and the number
/// of samples: see `evaluateExact`. Returns minus the gradient of the head at the hull, in its frame: where
/// the pressure pushes, as `up` does in flat water. With a tolerance of 0 triangles
/// are summed up one by one whatever `sum`.
Vec3 addHullInWaves(const Hull& hull, const Pose& pose, const WaterField& water,
                    const HydrostaticQuery& query, MeshSum sum, WetIntegrals& integrals);

}  // namespace bullet_buoyancy
