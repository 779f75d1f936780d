#include <algorithm>
#include <cmath>

#include "hard_cases/hard_case.h"
#include "hard_cases/names.h"
#include "scenes/dropped_body.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// No body may rise above the height that its energy allows: the thousandth is what is seen of an error of
/// energy, and of Bullet's rounding.
constexpr double riseLimit = 1.001;
constexpr double energyLimit = 1e-3;

/// A cube at rest swings by no more than a few 1e-3 of a radian at the speed that is taken for rest.
constexpr double tiltLimit = 0.5 * pi / 180;

std::vector<Quantity> undamped(const DropDef& def, double seconds) {
    const FallResult fall = fallUndamped(def, seconds);
    return {mustBe("finite", fall.finite),
            {"undamped: rises to", "allowed", fall.rise, riseLimit},
            {"undamped: energy gained", "released", fall.energyGain, energyLimit},
            {"undamped: most motion", "allowed", fall.motion, riseLimit * motionShown(def)}};
}

/// A cube that falls flat may stay so by symmetry, where that is not stable.
double tiltError(const DropDef& def, const SettleResult& rest) {
    const bool flat = def.orientation.angularDistance(Eigen::Quaterniond::Identity()) == 0;
    const double error = cubeTiltError(def.ratio, rest.up);
    return flat ? std::min(error, tiltOfFace(rest.up)) : error;
}

std::vector<Quantity> settled(const DropDef& def) {
    // Light ones are wet so briefly that they bounce for days; what has exploded never comes to rest.
    const double limitSeconds = def.scene.floater == Floater::library ? 4e5 : 2000;
    const SettleResult rest = settle(def, limitSeconds);
    std::vector<Quantity> quantities{mustBe("at rest in the end", rest.atRest && rest.finite),
                                     {"settled: wet share off", "draft", rest.wetError, wetErrorLimit(def)}};
    if (def.solid == Solid::box && def.size.minCoeff() == def.size.maxCoeff())
        quantities.push_back({"settled: tilt off", "rad", tiltError(def, rest), tiltLimit});
    return quantities;
}

/// Undamped for so long that it comes down some ten times, s.
double bouncing(const DropDef& def) {
    return std::max(20.0, 20 * std::sqrt(2 * def.height / def.scene.gravity));
}

std::vector<Quantity> both(const DropDef& def, double undampedSeconds) {
    std::vector<Quantity> quantities = undamped(def, undampedSeconds);
    for (const Quantity& quantity : settled(def))
        quantities.push_back(quantity);
    return quantities;
}

void addGrid(std::vector<HardCase>& cases) {
    for (const bool turned : {false, true})
        for (double ratio : {1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9, 0.999})
            for (double edge : {0.01, 0.05, 1.0, 20.0})
                for (double dt : {1.0 / 240, 1.0 / 60, 1.0 / 30, 0.1}) {
                    DropDef def;
                    def.size = Vec3::Constant(edge);
                    def.ratio = ratio;
                    def.height = 2 * edge;
                    def.stepping.dt = dt;
                    if (turned) def.orientation = askew();
                    const bool quick = (edge == 0.05 || edge == 1) && (dt < 0.005 ? false : dt != 1.0 / 30);
                    cases.push_back(
                        {std::string("grid ") + (turned ? "askew" : "face up") + "/ratio " + text(ratio),
                         text(edge) + " m, " + stepName(dt), quick, [def](Floater floater) {
                             DropDef floated = def;
                             floated.scene.floater = floater;
                             return both(floated, bouncing(floated));
                         }});
                }
}

void addSlender(std::vector<HardCase>& cases) {
    for (const bool needle : {true, false})
        for (double ratio : {1e-3, 0.01, 0.1, 0.5})
            for (double dt : {1.0 / 60, 0.1}) {
                DropDef def;
                def.size = needle ? Vec3(0.05, 0.05, 5) : Vec3(5, 5, 0.05);
                def.ratio = ratio;
                def.height = 5;
                def.orientation = askew();
                def.stepping.dt = dt;
                cases.push_back({std::string(needle ? "needle" : "plate") + "/ratio " + text(ratio),
                                 stepName(dt), ratio == 0.01, [def](Floater floater) {
                                     DropDef floated = def;
                                     floated.scene.floater = floater;
                                     return both(floated, bouncing(floated));
                                 }});
            }
}

/// Undamped for so long that they come back and rise once more, s.
constexpr double plungeSeconds = 120;

void addPlunge(std::vector<HardCase>& cases, const std::string& group, DropDef def) {
    for (double dt : {1.0 / 60, 1.0 / 30}) {
        def.stepping.dt = dt;
        cases.push_back({group, stepName(dt), true, [def](Floater floater) {
                             DropDef floated = def;
                             floated.scene.floater = floater;
                             return both(floated, plungeSeconds);
                         }});
    }
}

void addPlunges(std::vector<HardCase>& cases) {
    for (double ratio : {0.01, 0.5}) {
        DropDef fast;
        fast.ratio = ratio;
        fast.downwardSpeed = 100;
        fast.orientation = askew();
        addPlunge(cases, "fall at 100 m/s/ratio " + text(ratio), fast);
    }
    DropDef ball;
    ball.solid = Solid::sphere;
    ball.size = Vec3::Constant(0.3);
    ball.ratio = 0.01;
    ball.height = -100;
    addPlunge(cases, "light ball from 100 m below", ball);
}

/// The closed form of linear drag; the velocity is Bullet's, rounded, of what is left after gravity of a
/// step.
void addTerminalVelocity(std::vector<HardCase>& cases) {
    constexpr double limit = 1e-4;
    struct Ball {
        double ratio, drag;
    };
    for (const Ball& ball : {Ball{0.01, 300}, Ball{0.5, 3}, Ball{2, 3}})
        for (double dt : {1.0 / 60, 0.1}) {
            DropDef def;
            def.solid = Solid::sphere;
            def.size = Vec3::Constant(0.3);
            def.ratio = ball.ratio;
            def.height = ball.ratio < 1 ? -1000 : -1;
            def.stepping.dt = dt;
            cases.push_back({"terminal velocity", "ratio " + text(ball.ratio) + ", " + stepName(dt), true,
                             [def, ball](Floater floater) {
                                 DropDef floated = def;
                                 floated.scene.floater = floater;
                                 return std::vector<Quantity>{{"speed off", "expected",
                                                               terminalVelocityError(floated, ball.drag),
                                                               limit}};
                             }});
        }
}

}  // namespace

void addDroppedBodies(std::vector<HardCase>& cases) {
    addGrid(cases);
    addSlender(cases);
    addPlunges(cases);
    addTerminalVelocity(cases);
}

}  // namespace bullet_buoyancy::demo
