#pragma once

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy {

/// The truth to measure evaluators against: slow, in double precision, and from the other side of Gauss's
/// theorem.
///
/// In flat water: closed meshes by Archimedes on the displaced volume, as signed tetrahedra clipped at the
/// surface, the waterplane from its outline; exact but for rounding. Open meshes: pressure over adaptively
/// quartered triangles, to 1e-7 of the weight of water in the bounding box. Solids: pressure over their
/// curved surface, by Gauss quadrature along the axis and round the wet arc, to 1e-8.
///
/// In waves: pressure under the true surface, the field asked at every point of an adaptive quadrature over
/// the hull's true surface, to 1e-8 of the weight of water that the whole hull displaces whatever the query's
/// tolerance (see `ReferenceTolerance`); `forceErrorBound` is that of the quadrature. The waterplane is
/// level: the shadow of the wet surface, lifted straight up on the water. The stiffness takes depth to change
/// everywhere as under the centre of buoyancy. Energy under `PressureModel::waveDynamic` is of first order in
/// the waves. Needs finite bounds of slope and curvature (asserted).
///
/// Same arguments and result as `evaluateExact`.
HydrostaticResult evaluateReference(const Hull& hull, const Pose& pose, const WaterField& water,
                                    const HydrostaticQuery& query = {});

}  // namespace bullet_buoyancy
