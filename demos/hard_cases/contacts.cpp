#include "hard_cases/hard_case.h"
#include "hard_cases/names.h"
#include "scenes/cargo.h"
#include "scenes/harbour.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// Bullet lets resting bodies sink into each other by about a centimetre, and its joints give a little.
constexpr double sinkLimit = 0.02;   // m
constexpr double jointLimit = 0.05;  // m
constexpr double restLimit = 0.02;   // m/s: what its contacts leave of a body at rest

/// With room for the sinking of each contact, and for Bullet's stacks creep sideways: by 0.13 of a size even
/// on solid ground. One that has fallen over is out in height by more than a size.
std::vector<Quantity> cargo(const CargoResult& result) {
    return {mustBe("finite", result.finite),
            {"displacement off", "expected", result.displacementError, 0.01},
            {"shifted on deck by", "size", result.worstShift, 0.4},
            {"height on deck off", "size", result.worstHeightError, 0.15},
            {"raft's tilt", "rad", result.tilt, 0.02}};
}

std::vector<Quantity> held(const HeldResult& result, double riseLimit, double speedLimit = restLimit) {
    return {mustBe("finite", result.finite),
            {"rises by", "m", result.highest, riseLimit},
            {"sinks into its hold by", "m", result.deepest, sinkLimit},
            {"speed in the end", "m/s", result.speed, speedLimit}};
}

std::vector<Quantity> chained(const ChainResult& result) {
    // Laid to the waterline, the barrels bob up to their draft, and past it by as much: 0.15 m above the
    // water.
    return {mustBe("finite", result.finite),
            {"a joint's gap", "m", result.widestGap, jointLimit},
            {"highest barrel", "m", result.highest, 0.4},
            {"speed in the end", "m/s", result.speed, restLimit}};
}

/// Boxes that 99 g press to a wall jitter in Bullet, on solid ground as well: by 2 % of the velocity that
/// they are given in a step.
std::vector<Quantity> underDeck(const DeckResult& result, double dt) {
    constexpr double jitter = 0.04;
    std::vector<Quantity> quantities = held(result.held, sinkLimit, jitter * 99 * standardGravity * dt);
    quantities.push_back({"let go: rises to", "allowed", result.rise, 1.001});
    quantities.push_back(mustBe("at rest in the end", result.settled));
    quantities.push_back({"settled: wet share off", "draft", result.wetError, 0.01});
    return quantities;
}

}  // namespace

void addContacts(std::vector<HardCase>& cases) {
    for (double dt : {1.0 / 240, 1.0 / 60}) {
        const Stepping stepping{dt, 1};
        const bool quick = dt == 1.0 / 60;
        const std::string step = stepName(dt);
        cases.push_back({"ten crates on a raft/" + step, "", quick,
                         [=](Floater floater) { return cargo(stackCratesOnRaft(floater, stepping)); }});
        cases.push_back({"inflatable raft with 300 kg/" + step, "", quick,
                         [=](Floater floater) { return cargo(loadInflatableRaft(floater, stepping)); }});
        cases.push_back({"thirty barrels on a chain/" + step, "", quick,
                         [=](Floater floater) { return chained(chainBarrels(floater, stepping)); }});
        cases.push_back({"crate between walls/" + step, "", quick,
                         [=](Floater floater) { return held(wedgeCrate(floater, stepping), 0.05); }});
        for (double ratio : {0.05, 0.5})
            // Let go where the water is as deep as nothing, they may float up by less than their size.
            cases.push_back({"beach, ratio " + text(ratio) + "/" + step, "", quick,
                             [=](Floater floater) { return held(beach(ratio, floater, stepping), 0.5); }});
        cases.push_back({"light boxes under a deck/" + step, "", quick,
                         [=](Floater floater) { return underDeck(holdUnderDeck(floater, stepping), dt); }});
    }
}

}  // namespace bullet_buoyancy::demo
