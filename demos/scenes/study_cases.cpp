#include "scenes/study_cases.h"

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/random_numbers.h"

namespace bullet_buoyancy::scenes {

std::vector<StudyCase> casesAcross(const WaterField& water, const Hull& hull, int count) {
    const FlatWater flat(WaterFrame::zUp());
    RandomNumbers random(20261125);
    std::vector<StudyCase> cases;
    while (cases.size() < std::size_t(count)) {
        StudyCase c;
        c.time = random.uniform(0, 1000);
        const double x = random.uniform(-1000, 1000), y = random.uniform(-1000, 1000);
        const double height = random.uniform(-1, 1) * hull.bounds.radius;
        const Eigen::Quaterniond orientation = random.orientation();
        c.inFlatWater = {Vec3(x, y, height) - orientation * hull.bounds.centre, orientation};
        c.pose = c.inFlatWater;
        c.pose.position.z() += elevationAt(water, {x, y}, c.time);
        const double wet = evaluateExact(hull, c.inFlatWater, flat).submergedVolume / hull.moments.volume;
        if (wet >= 0.01 && wet <= 0.99) cases.push_back(c);
    }
    return cases;
}

double elevationAt(const WaterField& water, const Vec2& place, double time) {
    const Eigen::ArrayX2d point = place.transpose().array();
    Eigen::ArrayX3d surface(1, 3);
    water.sampleSurface(point, time, surface);
    return surface(0, 0);
}

}  // namespace bullet_buoyancy::scenes
