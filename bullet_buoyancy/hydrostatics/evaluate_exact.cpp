#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"

#include "bullet_buoyancy/hydrostatics/evaluate_hull.h"

namespace bullet_buoyancy {

HydrostaticResult evaluateExact(const Hull& hull, const Pose& pose, const WaterField& water,
                                const HydrostaticQuery& query) {
    return evaluateHull(hull, pose, water, query, MeshSum::oneByOne);
}

}  // namespace bullet_buoyancy
