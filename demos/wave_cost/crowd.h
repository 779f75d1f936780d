#pragma once

#include <vector>

#include "scenes/float_scene.h"
#include "scenes/timed_scene.h"

namespace bullet_buoyancy::demo {

/// Boxes of 1 m and a density ratio of 0.5 that float in any water, by an action of their own; 4 m apart, so
/// that they do not touch.
class Crowd {
public:
    /// The water must outlive the crowd; its frame must be z up.
    Crowd(const WaterField& water, const BuoyancySettings& settings, int count);
    ~Crowd();
    Crowd(const Crowd&) = delete;
    Crowd& operator=(const Crowd&) = delete;

    /// Steps of 1/60 s. Returns ns a body of a step: median over the steps of the action's part, mean of the
    /// whole.
    scenes::SubstepTime step(int steps);

    /// ns to evaluate the pressure on a body by itself, mean over all of them where they are now.
    double evaluate() const;

    /// Points at which an evaluation asks the water, mean.
    double samples() const;

    const BuoyancyAction& action() const { return m_action; }

    /// Of the water's pressure in the last step, a body, mean.
    double evaluations() const;

private:
    HydrostaticQuery query() const;

    const WaterField& m_water;
    BuoyancySettings m_settings;
    BuoyancyAction m_action;
    scenes::Stopwatch m_stopwatch{m_action};
    scenes::FloatScene m_scene;
    std::vector<btRigidBody*> m_bodies;
    std::shared_ptr<const Hull> m_hull;
};

}  // namespace bullet_buoyancy::demo
