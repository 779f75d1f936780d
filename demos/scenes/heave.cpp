#include "scenes/heave.h"

#include <algorithm>
#include <cmath>

#include "scenes/known_answers.h"

namespace bullet_buoyancy::scenes {

namespace {

constexpr double ratio = 0.5, amplitude = 0.1, seconds = 60;

struct Extreme {
    double time, height;
};

/// Of the parabola through three samples `dt` apart, the middle one at `time`.
Extreme vertex(double before, double middle, double after, double time, double dt) {
    const double slope = (after - before) / 2, curvature = after - 2 * middle + before;
    return {time - dt * slope / curvature, middle - slope * slope / (2 * curvature)};
}

/// The highest points (`sign` 1) or lowest (-1) of a series, with their times.
std::vector<Extreme> extremes(const std::vector<double>& heights, double sign, double dt) {
    std::vector<Extreme> found;
    for (std::size_t i = 1; i + 1 < heights.size(); ++i)
        if (sign * heights[i] > sign * heights[i - 1] && sign * heights[i] >= sign * heights[i + 1])
            found.push_back(vertex(heights[i - 1], heights[i], heights[i + 1], double(i + 1) * dt, dt));
    return found;
}

/// Mean over the last full periods.
double meanOfLast(const std::vector<Extreme>& extremes) {
    constexpr std::size_t periods = 3;
    double sum = 0;
    for (std::size_t i = extremes.size() - periods; i < extremes.size(); ++i)
        sum += extremes[i].height;
    return sum / double(periods);
}

}  // namespace

HeaveError heaveFreely(const HeaveDef& def) {
    SceneDef sceneDef;
    sceneDef.floater = def.floater;
    FloatScene scene(sceneDef);
    Pose pose;
    pose.position.z() = 0.5 - ratio + amplitude;
    BodyDef frictionless;
    frictionless.linearDrag = frictionless.angularDamping = 0;
    btRigidBody& slab = scene.addFloatingBox({2, 2, 1}, ratio, pose, frictionless);

    std::vector<double> heights;
    scene.step(def.stepping.dt, def.stepping.substeps);  // Bullet alone moves the slab in its first one
    while (scene.time() < seconds) {
        scene.step(def.stepping.dt, def.stepping.substeps);
        if (!isFinite(scene, slab)) return {1, 1, false};
        heights.push_back(heightAboveWater(slab, scene.water()));
    }
    const std::vector<Extreme> peaks = extremes(heights, 1, def.stepping.dt);
    const std::vector<Extreme> troughs = extremes(heights, -1, def.stepping.dt);
    if (std::min(peaks.size(), troughs.size()) < 10) return {1, 1, true};  // it does not heave
    const double kept = (meanOfLast(peaks) - meanOfLast(troughs)) / 2;
    const double period = (peaks.back().time - peaks.front().time) / double(peaks.size() - 1);
    return {1 - kept / amplitude, std::abs(period / heavePeriod(ratio, standardGravity) - 1), true};
}

}  // namespace bullet_buoyancy::scenes
