// The snippets of README.md beside that of tests/consumer/main.cpp.

// [snippet]
#include <bullet_buoyancy/bullet_buoyancy.h>
// [end]

#include <gtest/gtest.h>

#include <cstdio>

#include "docs/pool.h"

namespace {

TEST(Readme, SetsABodysSettingsToTheirDefaults) {
    bullet_buoyancy::test::Pool pool;
    btRigidBody* const barrel = &pool.addBox({1, 1, 1}, 100, {0, 0, 0});
    const bullet_buoyancy::FlatWater sea(bullet_buoyancy::WaterFrame::yUp());
    bullet_buoyancy::BuoyancyAction buoyancy(sea);
    // [snippet]
    bullet_buoyancy::BodyDef def;
    def.linearDrag = 3;             // 1/s under water, relative to the water; 0 and
    def.angularDamping = 1.01;      // 1/s: 0 is a frictionless sea
    def.scaleByWetFraction = true;  // false: in full whenever wet
    def.hull = nullptr;             // or a mesh of your own: makeHull(TriangleMesh{vertices, triangles}).hull
    buoyancy.addBody(*barrel, def);
    // [end]
    const bullet_buoyancy::BodyDef defaults;
    EXPECT_EQ(buoyancy.bodyCount(), 1u);
    EXPECT_EQ(def.linearDrag, defaults.linearDrag);
    EXPECT_EQ(def.angularDamping, defaults.angularDamping);
    EXPECT_EQ(def.scaleByWetFraction, defaults.scaleByWetFraction);
    EXPECT_EQ(def.hull, defaults.hull);
}

TEST(Readme, MakesASea) {
    // [snippet]
    bullet_buoyancy::SeaStateDef state;
    state.spectrum.significantHeight = 1;  // m
    state.spectrum.peakPeriod = 6;         // s; JONSWAP, or Pierson-Moskowitz with peakEnhancement = 1
    state.spreading = 10;                  // of directions; infinite: all crests are parallel
    state.seed = 1;
    bullet_buoyancy::AiryWavesDef waves;
    waves.components = bullet_buoyancy::makeSeaState(state).components;
    bullet_buoyancy::AiryWaves sea(bullet_buoyancy::WaterFrame::yUp(), waves);

    bullet_buoyancy::BuoyancySettings settings;
    settings.pressure = bullet_buoyancy::PressureModel::waveDynamic;  // Froude-Krylov; default: hydrostatic
    settings.tolerance = 1e-2;  // error of the force over the weight of water that the whole hull displaces
    bullet_buoyancy::BuoyancyAction buoyancy(sea, settings);
    // [end]
    EXPECT_TRUE(sea.status());
    EXPECT_FALSE(sea.bounds().isFlat());
    EXPECT_EQ(buoyancy.time(), 0);
}

TEST(Readme, GoesBackToWhatItSaved) {
    bullet_buoyancy::test::Pool pool;
    btRigidBody& crate = pool.addBox({1, 1, 1}, 100, {0, 1, 0});
    const bullet_buoyancy::FlatWater sea(bullet_buoyancy::WaterFrame::yUp());
    bullet_buoyancy::BuoyancyAction buoyancy(sea);
    pool.world.addAction(&buoyancy);
    buoyancy.addBody(crate);
    pool.run(1);
    const btVector3 place = crate.getWorldTransform().getOrigin();
    // [snippet]
    bullet_buoyancy::ActionState state;  // bytes, 2.5 kB a body: copy, compare, send or store them
    buoyancy.save(state);                // reused, it allocates nothing, and neither does restore
    // ... steps that are to be taken back, or another process that has made the same bodies ...
    const auto status = buoyancy.restore(state);
    if (!status) std::puts(status.describe().c_str());  // what differs; nothing has changed
    // [end]
    EXPECT_TRUE(status);
    pool.run(1);
    EXPECT_NE(crate.getWorldTransform().getOrigin(), place);
    EXPECT_TRUE(buoyancy.restore(state));
    EXPECT_EQ(crate.getWorldTransform().getOrigin(), place);
    pool.world.removeAction(&buoyancy);
}

}  // namespace
