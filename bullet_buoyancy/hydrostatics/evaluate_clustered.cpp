#include "bullet_buoyancy/hydrostatics/evaluate_clustered.h"

#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateClustered(const Hull& hull, const Pose& pose, const WaterField& water,
                                    const HydrostaticQuery& query) {
    return evaluateHull(hull, pose, water, query, MeshSum::inClusters);
}

}  // namespace bullet_buoyancy
