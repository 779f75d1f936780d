// Any bytes as a saved state: refused with nothing changed, or taken as they are; and never the end of the
// world.

#include "bullet_buoyancy/water/airy_waves.h"
#include "fuzz/expect.h"
#include "fuzz/state_bytes.h"
#include "support/mixed_fleet.h"

namespace bullet_buoyancy::fuzz {
namespace {

constexpr int bodies = 4;

AiryWaves waves() {
    WaveComponent wave;
    wave.amplitude = 0.2;
    wave.wavenumber = 0.5;
    wave.frequency = frequencyOfWavenumber(wave.wavenumber);
    return AiryWaves(WaterFrame::zUp(), {{wave}});
}

/// Bodies in waves, in a world without contacts, which no state has.
class Voyage {
public:
    Voyage() {
        m_dispatcher.setNearCallback(
            [](btBroadphasePair&, btCollisionDispatcher&, const btDispatcherInfo&) {});
        step(3);
    }

    void step(int steps) {
        for (int i = 0; i < steps; ++i)
            m_fleet.step();
    }

    BuoyancyAction& buoyancy() { return m_fleet.buoyancy(); }
    ActionState save() { return buoyancy().save(); }

private:
    AiryWaves m_waves = waves();
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    test::MixedFleet m_fleet{m_world, m_waves, bodies};
};

bool isSame(const ActionState& a, const ActionState& b) {
    return a.bytes == b.bytes;
}

void checkRestore(Voyage& voyage, const ActionState& state) {
    const ActionState before = voyage.save();
    const RestoreStatus status = voyage.buoyancy().restore(state);
    BUOYANCY_EXPECT(!status.describe().empty(), "no words");
    const ActionState after = voyage.save();
    if (!status) {
        BUOYANCY_EXPECT(isSame(after, before), "refused (%s), and changed", status.describe().c_str());
        return;
    }
    // Bullet has no room for some numbers, and takes damping beyond 1 for 1; what it has it keeps.
    BUOYANCY_EXPECT(voyage.buoyancy().restore(after), "what was saved is refused");
    BUOYANCY_EXPECT(isSame(voyage.save(), after), "%zu bytes", after.bytes.size());
    voyage.step(2);
}

}  // namespace
}  // namespace bullet_buoyancy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace bullet_buoyancy::fuzz;
    Voyage voyage;
    const auto home = voyage.save();
    BUOYANCY_EXPECT(checkSum(home.bytes) == word(home.bytes, words(home.bytes) - 1), "another check sum");
    voyage.step(2);
    const auto expected = voyage.save();

    Input input(bytes, size);
    checkRestore(voyage, readState(input, home));

    // From wherever that has led.
    BUOYANCY_EXPECT(voyage.buoyancy().restore(home), "home is out of reach");
    voyage.step(2);
    BUOYANCY_EXPECT(isSame(voyage.save(), expected), "another voyage");
    return 0;
}
