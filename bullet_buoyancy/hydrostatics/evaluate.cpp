#include "bullet_buoyancy/hydrostatics/evaluate.h"

#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

namespace bullet_buoyancy {

HydrostaticResult evaluate(const Hull& hull, const Pose& pose, const WaterField& water,
                           const HydrostaticQuery& query) {
    return evaluateHull(hull, pose, water, query, MeshSum::inClusters);
}

}  // namespace bullet_buoyancy
