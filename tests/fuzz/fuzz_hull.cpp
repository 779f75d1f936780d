// Any mesh as a hull: refused with a reason, or sound.

#include <cmath>

#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "fuzz/check_hull.h"
#include "fuzz/read_mesh.h"

namespace bullet_buoyancy::fuzz {
namespace {

/// What was repaired needs no repair.
void checkRepairedTwice(const Hull& hull) {
    const HullResult again = makeHull(hull.mesh);
    BUOYANCY_EXPECT(again.hull, "%s", again.status.describe().c_str());
    BUOYANCY_EXPECT(again.status.degenerateTriangles == 0 && again.status.weldedVertices == 0 &&
                        again.status.duplicateTriangles == 0,
                    "%s", again.status.describe().c_str());
    // Which of two shells that cross or touch is within the other may be a matter of rounding.
    if (!hull.meshIsClosed || again.status.flippedTriangles > 0) return;
    const double volume = hull.moments.volume, other = again.hull->moments.volume;
    const double reach = hull.bounds.centre.norm() + hull.bounds.radius;
    const double rounding = 1e-9 * volume + 1e-14 * reach * hull.surfaceArea;
    BUOYANCY_EXPECT(std::abs(other - volume) <= rounding, "%g, then %g m^3", volume, other);
}

/// Half in water, turned anyhow.
void checkEvaluates(const Hull& hull, Input& input) {
    const FlatWater water(WaterFrame::zUp());
    Pose pose;
    pose.orientation = Eigen::Quaterniond(1, input.unit(), input.unit(), input.unit()).normalized();
    pose.position = -(pose.orientation * hull.bounds.centre);
    const HydrostaticResult result = evaluate(hull, pose, water);
    BUOYANCY_EXPECT(result.forceWorld.allFinite() && result.torqueAboutCom.allFinite(), "%g m^3",
                    hull.moments.volume);
    BUOYANCY_EXPECT(std::isfinite(result.submergedVolume), "of %g m^3", hull.moments.volume);
}

}  // namespace
}  // namespace bullet_buoyancy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace bullet_buoyancy::fuzz;
    Input input(bytes, size);
    const auto result = bullet_buoyancy::makeHull(readMesh(input));
    checkHull(result);
    if (!result.hull) return 0;
    checkRepairedTwice(*result.hull);
    checkEvaluates(*result.hull, input);
    return 0;
}
