#pragma once

#include "scenes/flotsam.h"

namespace bullet_buoyancy::demo {

/// A floating boom round the middle of a scene, without which everything would drift apart and away within
/// the hour: it pulls what is outside `reach` (m) back by its weight a `give` (m), horizontally.
class Boom {
public:
    Boom(double reach, double give) : m_reach(reach), m_give(give) {}

    /// To be called before each step.
    void pull(scenes::FlotsamScene& scene) const;

private:
    double m_reach, m_give;
};

}  // namespace bullet_buoyancy::demo
