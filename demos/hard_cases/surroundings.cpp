#include "scenes/surroundings.h"

#include <cmath>

#include "hard_cases/hard_case.h"
#include "hard_cases/names.h"
#include "scenes/dropped_body.h"
#include "scenes/random_bodies.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// Bullet rounds the position in each step, by chance: after n steps energy is off by sqrt(n) roundings, of
/// which twice that pass, and the height by one more.
std::vector<Quantity> far(const DropDef& def) {
    constexpr double seconds = 20;
    const double rounding = positionRounding(def) / def.height;
    const double chance = 2 * rounding * std::sqrt(seconds / def.stepping.dt);
    // What a rounding of all three coordinates in a step is of the fastest velocity.
    const double fastest = std::sqrt(2 * def.scene.gravity * def.height);
    const double jump = std::sqrt(3.0) * positionRounding(def) / def.stepping.dt / fastest;
    const FallResult fall = fallUndamped(def, seconds);
    const SettleResult rest = settle(def, 600);
    return {mustBe("finite", fall.finite && rest.finite),
            {"undamped: rises to", "allowed", fall.rise, 1.001 + chance + rounding},
            {"undamped: energy gained", "released", fall.energyGain, 1e-3 + chance},
            {"undamped: most motion", "allowed", fall.motion, 1.001 + chance + 2 * jump + jump * jump},
            mustBe("at rest in the end", rest.atRest),
            {"settled: wet share off", "draft", rest.wetError, wetErrorLimit(def, BodyDef{})}};
}

void addFar(std::vector<HardCase>& cases) {
    for (double distance : {1e4, 1e5})
        for (double ratio : {0.1, 0.5}) {
            DropDef def;
            def.ratio = ratio;
            def.orientation = askew();
            def.scene.frame = WaterFrame::zUp({distance, distance, distance});
            cases.push_back({text(distance / 1000) + " km from the origin", "ratio " + text(ratio), true,
                             [def](Floater floater) {
                                 DropDef floated = def;
                                 floated.scene.floater = floater;
                                 return far(floated);
                             }});
        }
}

/// The same numbers in another order: rounded otherwise, and what was so a little different is a little more
/// so after three seconds of a tumble.
void addUps(std::vector<HardCase>& cases) {
    constexpr double seconds = 3, growth = 3e4;
    const double limit = growth * bulletRounding;
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {1.0, -1.0}) {
            const Vec3 up = sign * Vec3::Unit(axis);
            const std::string name = std::string(sign > 0 ? "+" : "-") + "xyz"[axis];
            cases.push_back({"gravity along each axis", name, true, [=](Floater floater) {
                                 const double difference = differenceOfUps(up, seconds, floater);
                                 return std::vector<Quantity>{{"height differs by", "m", difference, limit}};
                             }});
        }
    cases.push_back({"no gravity", "", true, [](Floater floater) {
                         return std::vector<Quantity>{
                             {"drifts by", "m", driftWithoutGravity(floater), 10 * bulletRounding}};
                     }});
}

/// Bullet adds gravity by the length of the step, after the action has cancelled it by that of the last one:
/// its body is off by up to g dt^2 after each change, and led back. So its poses say little of its motion.
void addUnevenSteps(std::vector<HardCase>& cases) {
    for (double ratio : {0.01, 0.1, 0.5}) {
        DropDef def;
        def.ratio = ratio;
        def.orientation = askew();
        def.stepping.dt = 0.1;
        def.shortestStep = 1.0 / 240;
        const double off = def.scene.gravity * std::pow(def.stepping.dt, 2) / def.height;
        cases.push_back({"steps of 1/240 to 1/10 s", "ratio " + text(ratio), true, [=](Floater floater) {
                             DropDef floated = def;
                             floated.scene.floater = floater;
                             const FallResult fall = fallUndamped(floated, 60);
                             const SettleResult rest = settle(floated, 3000);
                             return std::vector<Quantity>{
                                 mustBe("finite", fall.finite && rest.finite),
                                 {"undamped: rises to", "allowed", fall.rise, 1.001 + off},
                                 {"undamped: energy gained", "released", fall.energyGain, 1e-3},
                                 mustBe("at rest in the end", rest.atRest),
                                 {"settled: wet share off", "draft", rest.wetError, wetErrorLimit(def)}};
                         }});
    }
}

/// The phase w t is off by (w dt)^2 / 24 of itself, as in any method of second order. At the release Bullet
/// goes by whole steps, as if it were half a step later, and without water, which lets the slab fall by g
/// dt^2.
void addSubsteps(std::vector<HardCase>& cases) {
    for (double dt : {1.0 / 30, 1.0 / 60}) {
        const double w = std::sqrt(standardGravity / 0.5);
        const double phase = w * 5 * std::pow(w * dt, 2) / 24 + w * dt / 2;
        const double limit = 0.1 * phase + standardGravity * dt * dt;
        cases.push_back({"one substep or eight", stepName(dt), true, [=](Floater floater) {
                             return std::vector<Quantity>{
                                 {"height differs by", "m", differenceOfSubsteps(dt, floater), limit}};
                         }});
    }
}

void addRandomBodies(std::vector<HardCase>& cases) {
    const auto add = [&](int bodies, bool quick) {
        cases.push_back({text(bodies) + " random bodies", "", quick, [=](Floater floater) {
                             RandomBodiesDef def;
                             def.bodies = bodies;
                             def.stepsEach = 300;
                             def.floater = floater;
                             const RandomBodiesResult result = dropRandomBodies(def);
                             return std::vector<Quantity>{
                                 {"not finite", "bodies", double(result.notFinite), 0},
                                 {"energy gained", "scale", result.worstGain, 1e-3},
                                 {"gain more than 1e-3", "bodies", double(result.gainers), 0}};
                         }});
    };
    add(1000, true);
    add(20000, false);
}

}  // namespace

void addSurroundings(std::vector<HardCase>& cases) {
    addFar(cases);
    addUps(cases);
    addUnevenSteps(cases);
    addSubsteps(cases);
    addRandomBodies(cases);
}

}  // namespace bullet_buoyancy::demo
