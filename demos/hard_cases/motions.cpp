#include <algorithm>
#include <cmath>

#include "hard_cases/hard_case.h"
#include "hard_cases/names.h"
#include "scenes/current.h"
#include "scenes/heave.h"
#include "scenes/tumbling.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// What is asked for. The momentum is as exact as the numbers in which it is reported.
std::vector<Quantity> tumbled(const TumbleDef& def) {
    constexpr double energyLimit = 1e-6, orientationLimit = 1e-3;
    constexpr double reading = 100 * bulletRounding;
    const TumbleError error = tumble(def);
    return {mustBe("finite", error.finite),
            {"energy off by", "energy", error.energy, energyLimit},
            {"|L| off by", "|L|", error.momentum, reading},
            {"L turns by", "rad", error.direction, reading},
            {"orientation off", "rad", error.orientation, orientationLimit}};
}

void addTumbling(std::vector<HardCase>& cases) {
    const auto add = [&](const std::string& group, const Vec3& halfExtents, const Vec3& spin) {
        cases.push_back({group, "", true, [=](Floater floater) {
                             TumbleDef def;
                             def.halfExtents = halfExtents;
                             def.spin = spin;
                             def.floater = floater;
                             return tumbled(def);
                         }});
    };
    add("spinning rod", {0.05, 0.05, 1}, {3, 0, 6});
    add("middle-axis flip", {0.1, 0.3, 0.5}, {0.01, 5, 0.01});
}

void addCurrent(std::vector<HardCase>& cases) {
    for (double ratio : {1.0, 0.5})
        for (double dt : {1.0 / 240, 1.0 / 60, 0.1})
            cases.push_back({"drag of 1e4 1/s in a current",
                             std::string(ratio < 1 ? "afloat, " : "under water, ") + stepName(dt), true,
                             [=](Floater floater) {
                                 DriftDef def;
                                 def.ratio = ratio;
                                 def.stepping.dt = dt;
                                 def.floater = floater;
                                 const CurrentResult result = driftInCurrent(def);
                                 // The velocity is reported in Bullet's precision, 6e-8 of some 1 m/s.
                                 return std::vector<Quantity>{
                                     mustBe("finite", result.finite),
                                     {"past the current's speed", "start", result.overshoot, 1e-6},
                                     {"relative speed left", "start", result.remaining, 1e-6}};
                             }});
}

/// A method of second order errs by (w dt)^2 / 24 = 2.3e-4 of the period at 1/60 s, and 9e-4 at 1/30 s.
void addHeave(std::vector<HardCase>& cases) {
    struct Limit {
        double dt, amplitude, period;
    };
    for (const Limit& limit : {Limit{1.0 / 60, 0.005, 1e-3}, Limit{1.0 / 30, 0.015, 5e-3}})
        cases.push_back({"heave for 60 s", stepName(limit.dt), true, [limit](Floater floater) {
                             HeaveDef def;
                             def.floater = floater;
                             def.stepping.dt = limit.dt;
                             const HeaveError error = heaveFreely(def);
                             return std::vector<Quantity>{
                                 mustBe("finite", error.finite),
                                 {"amplitude lost", "0.1 m", error.amplitudeLost, limit.amplitude},
                                 {"amplitude gained", "0.1 m", -error.amplitudeLost, limit.amplitude},
                                 {"period off by", "period", error.period, limit.period}};
                         }});
}

}  // namespace

void addMotions(std::vector<HardCase>& cases) {
    addTumbling(cases);
    addCurrent(cases);
    addHeave(cases);
}

}  // namespace bullet_buoyancy::demo
