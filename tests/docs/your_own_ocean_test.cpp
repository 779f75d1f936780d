// The snippets of the guide "Your own ocean".

#include <bullet_buoyancy/bullet_buoyancy.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "docs/pool.h"
#include "support/known_solids.h"

using namespace bullet_buoyancy;

// [snippet]
/// The waves that the engine's shader draws: a sum of amplitude cos(k . x - frequency t), k = (kx, ky).
class ShaderWaves final : public WaterField {
public:
    struct Wave {
        double amplitude, kx, ky, frequency;  // m, 1/m, 1/m, rad/s
    };

    ShaderWaves(const WaterFrame& frame, std::vector<Wave> waves)
        : WaterField(frame, seaWaterDensity), m_waves(std::move(waves)) {
        m_bounds.curvatureChange = 0;
        m_bounds.still = false;
        for (const Wave& wave : m_waves) {
            const double a = std::abs(wave.amplitude), k = std::hypot(wave.kx, wave.ky);
            m_bounds.elevation += a;
            m_bounds.slope += a * k;
            m_bounds.curvature += a * k * k;
            m_bounds.curvatureChange += a * k * k * k;
        }
    }

    WaterBounds bounds() const override { return m_bounds; }

    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override {
        samples.setZero();
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (const Wave& wave : m_waves) {
                const double angle = wave.kx * points(i, 0) + wave.ky * points(i, 1) - wave.frequency * time;
                const double slope = -wave.amplitude * std::sin(angle);
                samples(i, 0) += wave.amplitude * std::cos(angle);
                samples(i, 1) += slope * wave.kx;
                samples(i, 2) += slope * wave.ky;
            }
    }

    void sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const override {
        velocities.setZero();  // orbits in deep water, which shrink as e^(k z)
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (const Wave& wave : m_waves) {
                const double k = std::hypot(wave.kx, wave.ky);
                const double angle = wave.kx * points(i, 0) + wave.ky * points(i, 1) - wave.frequency * time;
                const double speed =
                    wave.amplitude * wave.frequency * std::exp(k * std::min(0.0, points(i, 2)));
                velocities(i, 0) += speed * wave.kx / k * std::cos(angle);
                velocities(i, 1) += speed * wave.ky / k * std::cos(angle);
                velocities(i, 2) += speed * std::sin(angle);
            }
    }

    /// With second derivatives and a bound of the third: it need not be given, but saves most samples.
    void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const override {
        sampleSurface(points, time, expansions.leftCols<3>());
        expansions.middleCols<3>(3).setZero();
        expansions.col(6) = m_bounds.curvatureChange;
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (const Wave& wave : m_waves) {
                const double height =
                    wave.amplitude *
                    std::cos(wave.kx * points(i, 0) + wave.ky * points(i, 1) - wave.frequency * time);
                expansions(i, 3) -= height * wave.kx * wave.kx;
                expansions(i, 4) -= height * wave.kx * wave.ky;
                expansions(i, 5) -= height * wave.ky * wave.ky;
            }
    }

private:
    std::vector<Wave> m_waves;
    WaterBounds m_bounds;
};
// [end]

namespace {

double heightAt(const WaterField& water, double x, double y, double time) {
    const Eigen::ArrayX2d point = Eigen::Array<double, 1, 2>(x, y);
    Eigen::ArrayX3d sample(1, 3);
    water.sampleSurface(point, time, sample);
    return sample(0, 0);
}

ShaderWaves twoWaves() {
    const double k = 0.3;
    return ShaderWaves(WaterFrame::yUp(), {{0.4, k, 0, frequencyOfWavenumber(k)},
                                           {0.2, 0, 2 * k, frequencyOfWavenumber(2 * k)}});
}

TEST(YourOwnOcean, WavesOfTheShaderAreWavesOfAiry) {
    const double k = 0.3, quarter = pi / 2;
    AiryWavesDef def;
    def.components = {{0.4, k, 0, frequencyOfWavenumber(k), 0},
                      {0.2, 2 * k, quarter, frequencyOfWavenumber(2 * k), 0}};
    const AiryWaves airy(WaterFrame::yUp(), def);
    const ShaderWaves waves = twoWaves();
    EXPECT_DOUBLE_EQ(waves.bounds().curvature, airy.bounds().curvature);
    const Eigen::ArrayX2d points = Eigen::ArrayX2d::Random(20, 2) * 50;
    Eigen::Array<double, Eigen::Dynamic, 7> expected(20, 7), expansions(20, 7);
    airy.expandSurface(points, 3, expected);
    waves.expandSurface(points, 3, expansions);
    EXPECT_LT((expected - expansions).leftCols<6>().abs().maxCoeff(), 1e-13);

    // The surface rises as its water does, to the differences' second order.
    const double h = 1e-4;
    const Eigen::ArrayX3d level = Eigen::ArrayX3d::Zero(1, 3);
    Eigen::ArrayX3d velocity(1, 3);
    waves.sampleVelocity(level, 3, velocity);
    EXPECT_NEAR(velocity(0, 2), (heightAt(waves, 0, 0, 3 + h) - heightAt(waves, 0, 0, 3 - h)) / (2 * h),
                h * h * 10);
}

TEST(YourOwnOcean, BoundsOfTheThirdDerivativeSaveSamples) {
    const ShaderWaves waves = twoWaves();
    FunctionWaterDef def;
    def.surface = [&](double x, double y, double time) -> Eigen::Array3d {
        const Eigen::ArrayX2d point = Eigen::Array<double, 1, 2>(x, y);
        Eigen::ArrayX3d sample(1, 3);
        waves.sampleSurface(point, time, sample);
        return sample.row(0).transpose();
    };
    def.bounds = waves.bounds();
    def.density = waves.density();
    const FunctionWater withoutBends(waves.frame(), def);
    const auto hull = test::hullOf(test::boxMesh({4, 1, 2}));
    const HydrostaticResult bent = evaluate(*hull, Pose(), waves),
                            unbent = evaluate(*hull, Pose(), withoutBends);
    EXPECT_LT(2 * bent.waterSamples, unbent.waterSamples);
    EXPECT_LT((bent.forceWorld - unbent.forceWorld).norm(), bent.forceErrorBound + unbent.forceErrorBound);
}

TEST(YourOwnOcean, FunctionsAreWaterToo) {
    test::Pool pool;
    btRigidBody& buoy = pool.addBox({0.5, 0.5, 0.5}, 60, {0, 0, 0});
    // [snippet]
    const double amplitude = 0.5, k = 2 * pi / 20, frequency = frequencyOfWavenumber(k);
    FunctionWaterDef def;
    def.surface = [=](double x, double, double time) -> Eigen::Array3d {
        const double angle = k * x - frequency * time;
        return {amplitude * std::cos(angle), -amplitude * k * std::sin(angle), 0};  // elevation and slopes
    };
    def.bounds.elevation = amplitude;
    def.bounds.slope = amplitude * k;
    def.bounds.curvature = amplitude * k * k;
    def.bounds.still = false;
    FunctionWater swell(WaterFrame::yUp(), def);
    // [end]
    BuoyancyAction buoyancy(swell);
    pool.world.addAction(&buoyancy);
    ASSERT_TRUE(buoyancy.addBody(buoy));
    pool.run(20);
    // [snippet]
    const Vec3 place = swell.frame().pointFromWorld(toEigen(buoy.getWorldTransform().getOrigin()));
    const Eigen::ArrayX2d points = place.head<2>().transpose().array();
    Eigen::ArrayX3d surface(1, 3);  // elevation and slopes, a row a point
    swell.sampleSurface(points, buoyancy.time(), surface);
    // [end]
    pool.world.removeAction(&buoyancy);
    // Long waves carry it: its draft is 0.24 m, and it lags behind by little of their height.
    EXPECT_NEAR(surface(0, 0) - place.z(), 0.24 - 0.25, 0.1 * amplitude);
    EXPECT_GT(evaluate(*hullFromShape(*buoy.getCollisionShape()).hull, Pose(), swell).waterSamples, 1);
    def.bounds = {};
    const FunctionWater declaredFlat(WaterFrame::yUp(), def);
    EXPECT_EQ(evaluate(*hullFromShape(*buoy.getCollisionShape()).hull, Pose(), declaredFlat).waterSamples, 0);
}

/// Of an engine: four waves on a grid of 64 by 64 nodes.
void readBack(double time, std::vector<float>& heights, std::vector<float>& rates) {
    constexpr int nodes = 64;
    constexpr double spacing = 0.5;
    const double k = 2 * pi / (spacing * nodes / 4), frequency = frequencyOfWavenumber(k);
    for (int y = 0; y < nodes; ++y)
        for (int x = 0; x < nodes; ++x) {
            const auto i = std::size_t(x + y * nodes);
            heights[i] = float(0.3 * std::cos(k * x * spacing - frequency * time));
            rates[i] = float(0.3 * frequency * std::sin(k * x * spacing - frequency * time));
        }
}

TEST(YourOwnOcean, HeightsAreSetEachFrame) {
    test::Pool pool;
    btRigidBody& buoy = pool.addBox({1, 0.5, 1}, 250, {0, 0, 0});
    btDiscreteDynamicsWorld& world = pool.world;
    // [snippet]
    HeightGridDef def;
    def.nodesX = def.nodesY = 64;
    def.spacing = 0.5;  // m
    def.origin = {-16, -16};
    def.periodic = true;  // as the tile of an FFT
    HeightGrid ocean(WaterFrame::yUp(), def);
    BuoyancyAction buoyancy(ocean);
    world.addAction(&buoyancy);
    buoyancy.addBody(buoy);

    std::vector<float> heights(64 * 64), rates(64 * 64);  // m, m/s; node (x, y) at x + y * 64
    for (int frame = 0; frame < 300; ++frame) {
        readBack(buoyancy.time() + 1 / 60., heights, rates);  // yours, of the step's end
        ocean.setHeights(heights.data(), rates.data());
        world.stepSimulation(1 / 60.f);
    }
    // [end]
    world.removeAction(&buoyancy);
    const Vec3 place = ocean.frame().pointFromWorld(toEigen(buoy.getWorldTransform().getOrigin()));
    EXPECT_TRUE(ocean.status());
    EXPECT_NEAR(heightAt(ocean, place.x(), place.y(), 0), place.z(), 0.1) << "half of it is under water";
}

/// What the guide says of spacings: errors of a sine of so many nodes a wavelength, over its amplitude.
double errorOfNodes(int nodesPerWave) {
    HeightGridDef def;
    def.nodesX = def.nodesY = 4 * nodesPerWave;
    def.periodic = true;
    HeightGrid grid(WaterFrame::zUp(), def);
    std::vector<double> heights(std::size_t(def.nodesX) * std::size_t(def.nodesY));
    const double k = 2 * pi / nodesPerWave;
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = std::sin(k * double(i % std::size_t(def.nodesX)));
    grid.setHeights(heights.data());
    double worst = 0;
    for (double x = 0; x < nodesPerWave; x += 0.01)
        worst = std::max(worst, std::abs(heightAt(grid, x, 0.3, 0) - std::sin(k * x)));
    return worst;
}

TEST(YourOwnOcean, NodesAreCloseEnough) {
    EXPECT_LT(errorOfNodes(8), 0.009);
    EXPECT_LT(errorOfNodes(16), 0.001);
}

/// Trochoids as an FFT gives them: where the vertex that rests at (x, y) is displaced to.
Vec3 displacementAt(const Vec2& rest, double amplitude, double k) {
    return {-amplitude * std::sin(k * rest.x()), 0, amplitude * std::cos(k * rest.x())};
}

TEST(YourOwnOcean, ChoppyWavesAreTurnedIntoHeights) {
    const double amplitude = 0.6, k = 1;
    const auto displacement = [&](const Vec2& rest) { return displacementAt(rest, amplitude, k); };
    // [snippet]
    /// Height (m) over a place of a surface whose vertices are displaced sideways as well.
    const auto heightOver = [&](const Vec2& place) {
        Vec2 rest = place;
        for (int i = 0; i < 20; ++i)
            rest = place - displacement(rest).head<2>();
        return displacement(rest).z();
    };
    // [end]
    GerstnerWavesDef def;
    def.components = {{amplitude, k, 0, frequencyOfWavenumber(k), 0}};
    const GerstnerWaves truth(WaterFrame::zUp(), def);
    // Each round leaves no more of the error than the steepness: 0.6^20 = 4e-5 of the amplitude at first.
    for (double x = 0; x < 2 * pi; x += 0.1)
        EXPECT_NEAR(heightOver({x, 0}), heightAt(truth, x, 0, 0), 4e-5) << x;
}

TEST(YourOwnOcean, ItsClockMayBeTheEngines) {
    const ShaderWaves waves = twoWaves();
    BuoyancyAction buoyancy(waves);
    const double engineTime = 123.4;
    // [snippet]
    buoyancy.setTime(engineTime);  // s; the next substep looks at the water a substep later
    // [end]
    EXPECT_EQ(buoyancy.time(), engineTime);
}

}  // namespace
