#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <chrono>
#include <ctime>
#include <vector>

#include "bullet_buoyancy/bullet/precision.h"
#include "scenes/statistics.h"

namespace bullet_buoyancy::scenes {

/// Processor time of this program, s, to about a microsecond: a step of some milliseconds is seldom spared by
/// other programs, and on a clock would seem longer than several short ones.
inline double processorTime() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

/// By the clock on the wall, s: for what runs in several threads.
inline double wallTime() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Times an action within the world's step, of many bodies: add it to the world in the action's place.
class Stopwatch : public btActionInterface {
public:
    explicit Stopwatch(btActionInterface& action, double (*clock)() = processorTime)
        : m_action(action), m_clock(clock) {}

    void updateAction(btCollisionWorld* world, btScalar dt) override {
        const double start = m_clock();
        m_action.updateAction(world, dt);
        m_times.push_back((m_clock() - start) * 1e9);
    }
    void debugDraw(btIDebugDraw*) override {}

    /// Forgets what was timed.
    void reset() { m_times.clear(); }

    /// ns a substep, of at least one; the first tenth warms up.
    double median() const {
        return scenes::median({m_times.begin() + std::ptrdiff_t(m_times.size() / 10), m_times.end()});
    }

private:
    btActionInterface& m_action;
    double (*m_clock)();
    std::vector<double> m_times;
};

}  // namespace bullet_buoyancy::scenes
