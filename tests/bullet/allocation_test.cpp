#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/study_seas.h"
#include "support/mixed_fleet.h"

// The linker leads every call of the C library's allocator in our objects here (Eigen's arrays come from
// there), and the language lets a program have its own operator new.
namespace {

int allocations = 0;
bool isCounting = false;

void count() {
    if (isCounting) ++allocations;
}

void* allocate(std::size_t size) {
    count();
    void* memory = std::malloc(size);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t number, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void* __wrap_malloc(std::size_t size) {
    count();
    return __real_malloc(size);
}
void* __wrap_calloc(std::size_t number, std::size_t size) {
    count();
    return __real_calloc(number, size);
}
void* __wrap_realloc(void* memory, std::size_t size) {
    count();
    return __real_realloc(memory, size);
}
}

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace bullet_buoyancy::test {
namespace {

/// Bullet's own containers.
void* countedForBullet(std::size_t size, int alignment) {
    count();
    return std::aligned_alloc(std::size_t(alignment), (size + std::size_t(alignment) - 1) /
                                                          std::size_t(alignment) * std::size_t(alignment));
}

/// Counts what the action allocates in its part of a step, and not what Bullet does in the rest of it.
class Watched final : public btActionInterface {
public:
    explicit Watched(btActionInterface& action) : m_action(action) {}

    void updateAction(btCollisionWorld* world, btScalar dt) override {
        isCounting = true;
        m_action.updateAction(world, dt);
        isCounting = false;
    }
    void debugDraw(btIDebugDraw*) override {}

private:
    btActionInterface& m_action;
};

int allocationsInSteps(const WaterField& water) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    MixedFleet fleet(world, water, 60);
    Watched watched(fleet.buoyancy());
    world.removeAction(&fleet.buoyancy());
    world.addAction(&watched);
    allocations = 0;
    for (int i = 0; i < 300; ++i)
        fleet.step();
    world.removeAction(&watched);
    return allocations;
}

class AStep : public testing::Test {
protected:
    static void SetUpTestSuite() { btAlignedAllocSetCustomAligned(countedForBullet, std::free); }
};

TEST_F(AStep, IsSeenToAllocateWhereItDoes) {
    isCounting = true;
    allocations = 0;
    const void* volatile seen = nullptr;  // or a compiler may leave out what nobody sees
    const Eigen::ArrayXd array = Eigen::ArrayXd::Zero(100);
    seen = array.data();
    EXPECT_EQ(allocations, 1);
    const double* one = new double(1);
    seen = one;
    delete one;
    EXPECT_NE(seen, nullptr);
    EXPECT_EQ(allocations, 3);  // operator new's malloc is counted as well
    isCounting = false;
}

TEST_F(AStep, AllocatesNothingInFlatWater) {
    EXPECT_EQ(allocationsInSteps(FlatWater(WaterFrame::zUp())), 0);
}

TEST_F(AStep, AllocatesNothingInACurrent) {
    FlatWaterDef def;
    def.flowVelocityWorld = {1, 0, 0};
    EXPECT_EQ(allocationsInSteps(FlatWater(WaterFrame::zUp(), def)), 0);
}

TEST_F(AStep, AllocatesNothingInWaves) {
    scenes::StudySeaDef def;
    def.significantHeight = 0.5;
    def.components = 8;
    EXPECT_EQ(allocationsInSteps(*scenes::airySea("sea", def).water), 0);
    EXPECT_EQ(allocationsInSteps(*scenes::gerstnerSea("sea", def).water), 0);
}

/// As in a game that goes back and forth.
TEST_F(AStep, IsSavedAndRestoredWithoutAllocations) {
    const FlatWater water(WaterFrame::zUp());
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    MixedFleet fleet(world, water, 20);
    ActionState state;
    fleet.buoyancy().save(state);
    fleet.step();
    allocations = 0;
    isCounting = true;
    fleet.buoyancy().save(state);
    const RestoreStatus status = fleet.buoyancy().restore(state);
    isCounting = false;
    EXPECT_TRUE(status);
    EXPECT_EQ(allocations, 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
