#include "support/random_sea.h"

#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/current.h"
#include "bullet_buoyancy/water/function_water.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "bullet_buoyancy/water/height_grid.h"
#include "bullet_buoyancy/water/sea_state.h"
#include "bullet_buoyancy/water/water_sum.h"
#include "support/random_waves.h"

namespace bullet_buoyancy::test {
namespace {

using WaterPointer = std::shared_ptr<const WaterField>;

WaterFrame anyFrame(Random& random) {
    return WaterFrame::fromUp(random.inCube(10), random.direction());
}

double anySteepness(Random& random) {
    return std::exp(random.uniform(std::log(0.01), std::log(0.4)));
}

AiryWavesDef airy(int count, Random& random, double depth = std::numeric_limits<double>::infinity()) {
    AiryWavesDef def;
    def.components = randomWaves(count, anySteepness(random), random, {depth});
    def.depth = depth;
    return def;
}

AiryWavesDef jonswap(Random& random) {
    SeaStateDef sea;
    sea.spectrum.peakPeriod = random.uniform(2.5, 7);
    sea.spectrum.significantHeight = random.uniform(0.002, 0.03) * sea.spectrum.peakPeriod *
                                     sea.spectrum.peakPeriod;  // up to about 1/50 of the length
    sea.spreading = random.coin() ? 10 : std::numeric_limits<double>::infinity();
    sea.seed = random.index(1000);
    AiryWavesDef def;
    def.components = makeSeaState(sea).components;
    return def;
}

/// Keeps the fields that it adds up.
class OwnedSum {
public:
    OwnedSum(const WaterFrame& frame, Random& random)
        : m_swell(frame, airy(2, random)),
          m_windSea(frame, airy(8, random)),
          m_current(frame, CurrentDef{random.direction()}),
          sum({&m_swell, &m_windSea, &m_current}) {}

private:
    AiryWaves m_swell, m_windSea;
    Current m_current;

public:
    WaterSum sum;
};

WaterPointer swellAndWindSea(const WaterFrame& frame, Random& random) {
    const auto owned = std::make_shared<OwnedSum>(frame, random);
    return {owned, &owned->sum};
}

WaterPointer grid(const WaterFrame& frame, Random& random) {
    HeightGridDef def;
    def.nodesX = def.nodesY = 32;
    def.spacing = 2;
    def.periodic = true;
    auto water = std::make_shared<HeightGrid>(frame, def);
    std::vector<double> heights;
    const double height = random.uniform(0.01, 0.1);
    for (int i = 0; i < 32 * 32; ++i)
        heights.push_back(random.uniform(-height, height));
    water->setHeights(heights.data());
    return water;
}

WaterPointer function(const WaterFrame& frame, Random& random) {
    const double height = random.uniform(0.01, 0.2), k = random.uniform(0.2, 1);
    FunctionWaterDef def;
    def.surface = [height, k](double x, double y, double) {
        const double sx = std::sin(k * x), cx = std::cos(k * x), sy = std::sin(k * y), cy = std::cos(k * y);
        return Eigen::Array3d(height * sx * sy, height * k * cx * sy, height * k * sx * cy);
    };
    def.bounds.elevation = height;
    def.bounds.slope = height * k;
    def.bounds.curvature = height * k * k;
    def.bounds.still = true;
    return std::make_shared<FunctionWater>(frame, def);
}

}  // namespace

RandomSea randomSea(std::size_t kind, Random& random) {
    const WaterFrame frame = anyFrame(random);
    const auto airyWaves = [&](const AiryWavesDef& def) { return std::make_shared<AiryWaves>(frame, def); };
    switch (kind % 9) {
        case 0:
            return {"one Airy wave", airyWaves(airy(1, random))};
        case 1:
            return {"four Airy waves", airyWaves(airy(4, random))};
        case 2:
            return {"16 Airy waves", airyWaves(airy(16, random))};
        case 3:
            return {"JONSWAP", airyWaves(jonswap(random))};
        case 4: {
            GerstnerWavesDef def;
            def.components = randomWaves(1 + int(random.index(8)), anySteepness(random), random);
            return {"Gerstner", std::make_shared<GerstnerWaves>(frame, def)};
        }
        case 5:
            return {"shallow water", airyWaves(airy(4, random, random.uniform(5, 20)))};
        case 6:
            return {"swell, wind sea and current", swellAndWindSea(frame, random)};
        case 7:
            return {"grid", grid(frame, random)};
        default:
            return {"function", function(frame, random)};
    }
}

Pose poseAcross(const WaterField& water, const Hull& hull, double time, Random& random) {
    const WaterFrame& frame = water.frame();
    Eigen::ArrayX2d point(1, 2);
    point << random.uniform(-100, 100), random.uniform(-100, 100);
    Eigen::ArrayX3d surface(1, 3);
    water.sampleSurface(point, time, surface);
    const double height = surface(0, 0) + random.uniform(-1, 1) * hull.bounds.radius;
    Pose pose;
    pose.orientation = random.orientation();
    pose.position = frame.originWorld() + frame.worldFromFrame() * Vec3(point(0, 0), point(0, 1), height) -
                    pose.orientation * hull.bounds.centre;
    return pose;
}

}  // namespace bullet_buoyancy::test
