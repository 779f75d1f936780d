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

/// `orientationLimit`: radians, see below.
std::vector<Quantity> tumbled(const TumbleDef& def, double orientationLimit) {
    // What poses show of the momentum differs from the true one by (spin dt)^2 / 12 or so.
    const double reading = std::pow(def.spin.norm() * def.stepping.dt, 2) / 12 + 1e-4;
    const TumbleError error = tumble(def);
    return {mustBe("finite", error.finite),
            {"energy off by", "energy", error.energy, 1e-3},
            {"|L| off by", "|L|", error.momentum, 2 * reading},
            {"L turns by", "rad", error.direction, 2 * reading},
            {"orientation off", "rad", error.orientation, orientationLimit}};
}

void addTumbling(std::vector<HardCase>& cases) {
    const auto add = [&](const std::string& group, const Vec3& halfExtents, const Vec3& spin, double limit) {
        cases.push_back({group, "", true, [=](Floater floater) {
                             TumbleDef def;
                             def.halfExtents = halfExtents;
                             def.spin = spin;
                             def.floater = floater;
                             return tumbled(def, limit);
                         }});
    };
    // A method of second order is late by (spin dt)^2 / 24 of all it has turned: 70 rad by 5e-4.
    add("spinning rod", {0.05, 0.05, 1}, {3, 0, 6}, 0.05);
    // Each flip multiplies what is off by e^(3 t); by twice what the method of second order would be late.
    add("middle-axis flip", {0.1, 0.3, 0.5}, {0.01, 5, 0.01}, 0.1);
}

void addCurrent(std::vector<HardCase>& cases) {
    for (double ratio : {1.0, 0.5})
        for (double dt : {1.0 / 240, 1.0 / 60, 0.1})
            cases.push_back({"drag of 1e4 1/s in a current",
                             std::string(ratio < 1 ? "afloat, " : "under water, ") + stepName(dt), true,
                             [=](Floater floater) {
                                 CurrentDef def;
                                 def.ratio = ratio;
                                 def.stepping.dt = dt;
                                 def.floater = floater;
                                 const CurrentResult result = driftInCurrent(def);
                                 // The velocity is Bullet's, rounded to 6e-8 of some 1 m/s.
                                 return std::vector<Quantity>{
                                     mustBe("finite", result.finite),
                                     {"past the current's speed", "start", result.overshoot, 1e-6},
                                     {"relative speed left", "start", result.remaining, 1e-6}};
                             }});
}

/// A method of second order errs by (w dt)^2 / 24 = 2.3e-4 of the period at 1/60 s, and 9e-4 at 1/30 s.
/// Bullet takes the first substep without water: the slab falls g dt^2, 3 % and 11 % of the amplitude, of
/// which the square can be seen.
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
