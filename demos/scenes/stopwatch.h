#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "bullet_buoyancy/bullet/precision.h"

namespace bullet_buoyancy::scenes {

/// Times an action within the world's step: add it to the world in the action's place.
class Stopwatch : public btActionInterface {
public:
    explicit Stopwatch(btActionInterface& action) : m_action(action) {}

    void updateAction(btCollisionWorld* world, btScalar dt) override {
        const auto start = std::chrono::steady_clock::now();
        m_action.updateAction(world, dt);
        const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - start;
        m_times.push_back(passed.count());
    }
    void debugDraw(btIDebugDraw*) override {}

    /// Forgets what was timed.
    void reset() { m_times.clear(); }

    /// ns a substep, of at least one; the first tenth warms up.
    double median() {
        const auto begin = m_times.begin() + std::ptrdiff_t(m_times.size() / 10);
        const auto middle = begin + (m_times.end() - begin) / 2;
        std::nth_element(begin, middle, m_times.end());
        return *middle;
    }

private:
    btActionInterface& m_action;
    std::vector<double> m_times;
};

}  // namespace bullet_buoyancy::scenes
