#include "bullet_buoyancy/hydrostatics/evaluate_batch.h"

#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateBatch(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& query) {
    return evaluateHull(hull, pose, water, query, MeshSum::inPacks);
}

}  // namespace bullet_buoyancy
