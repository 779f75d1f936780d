#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

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

/// Times an action within the world's step, of many bodies: add it to the world in the action's place.
class Stopwatch : public btActionInterface {
public:
    explicit Stopwatch(btActionInterface& action) : m_action(action) {}

    void updateAction(btCollisionWorld* world, btScalar dt) override {
        const double start = processorTime();
        m_action.updateAction(world, dt);
        m_times.push_back((processorTime() - start) * 1e9);
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
    std::vector<double> m_times;
};

}  // namespace bullet_buoyancy::scenes
