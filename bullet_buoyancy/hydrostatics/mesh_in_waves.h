#pragma once

#include "bullet_buoyancy/hull/packs.h"
#include "bullet_buoyancy/hydrostatics/wet_integrals.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Adds what waves do to the triangles of a mesh: depth and head at the corners and linear in between, with
/// what the surface bends within a triangle as a correction where it matters. Triangles are quartered where
/// they reach over cells of the patch, or where the bent waterline would be missed, until errors of the head
/// are about `headError` (m); the bound goes to `integrals.error`.
void addMeshInWaves(const TriangleMesh& mesh, const WaterPatch& water, double headError,
                    const HydrostaticQuery& query, WetIntegrals& integrals);

/// The same for `count` triangles of a pack, `which` of them, of a mesh with that origin.
void addInWaves(const TrianglePack<double>& pack, const std::uint8_t* which, int count, const Vec3& origin,
                const WaterPatch& water, double headError, const HydrostaticQuery& query,
                WetIntegrals& integrals);

/// The same with water that is sampled at every corner of every triangle, exactly for a surface that is
/// linear over each. Returns the number of samples.
int addMeshByCorners(const TriangleMesh& mesh, const WaterView& water, const HydrostaticQuery& query,
                     WetIntegrals& integrals);

}  // namespace bullet_buoyancy
