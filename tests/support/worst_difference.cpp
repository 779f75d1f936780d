#include "support/worst_difference.h"

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "support/compare_results.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

int posesAHull() {
    return BUOYANCY_TEST_POSES;
}

WorstDifference worstDifference(const Hull& hull, const WaterField& water, const Vec3& placeInFrame,
                                int poses) {
    const WaterFrame& frame = water.frame();
    const Vec3 onSurface = frame.originWorld() + frame.worldFromFrame() * placeInFrame;
    Random random(20261122);
    HydrostaticQuery query;
    query.wettedArea = query.waterplane = query.stiffness = true;
    WorstDifference worst;
    for (int i = 0; i < poses; ++i) {
        Pose pose;
        pose.orientation = random.orientation();
        const double heightOfCentre = frame.upWorld().dot(pose.orientation * hull.bounds.centre);
        const double height = random.uniform(-1.05, 1.05) * hull.bounds.radius;
        pose.position = onSurface + (height - heightOfCentre) * frame.upWorld();

        const HydrostaticResult exact = evaluateExact(hull, pose, water, query);
        const HydrostaticResult reference = evaluateReference(hull, pose, water, query);
        const double weightDensity = water.density() * query.gravity;
        worst.pressure = std::max(worst.pressure, relativeDifference(exact, reference, hull, weightDensity));
        worst.areas = std::max({worst.areas, relativeAreaDifference(exact, reference, hull),
                                relativeStiffnessDifference(exact, reference, hull, weightDensity)});
    }
    return worst;
}

}  // namespace bullet_buoyancy::test
