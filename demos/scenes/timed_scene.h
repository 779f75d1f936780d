#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "scenes/float_scene.h"
#include "scenes/stopwatch.h"

namespace bullet_buoyancy::scenes {

/// Bodies of about a metre, by their shapes.
struct NamedShapes {
    const char* name;
    int kinds;  ///< bodies have them in turn
    std::function<std::unique_ptr<btCollisionShape>(int kind)> makeShape;
};

/// Boxes; and boxes, convex hulls, balls, capsules and cylinders in turn.
std::vector<NamedShapes> shapesOfScenes();

/// Time of a substep, ns.
struct SubstepTime {
    double whole;   ///< Bullet and the action
    double action;  ///< the action alone
};

/// A world of bodies half as dense as the water, which float on a grid, apart from each other.
class TimedScene {
public:
    TimedScene(const NamedShapes& shapes, int bodies, double (*clock)() = processorTime);
    ~TimedScene();

    /// One substep of 1/60 s.
    SubstepTime step();

private:
    FloatScene m_scene;
    double (*m_clock)();
    Stopwatch m_stopwatch{m_scene.floater(), m_clock};
};

}  // namespace bullet_buoyancy::scenes
