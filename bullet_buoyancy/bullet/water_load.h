#pragma once

#include <algorithm>

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/bullet/buoyancy_settings.h"
#include "bullet_buoyancy/motion/load.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// The water as it meets the bodies in one substep.
struct WaterNow {
    const WaterField& field;
    WaterBounds bounds;
    double gravity;  ///< of the world, along the water frame's down, m/s^2
    double time;     ///< s
    BuoyancySettings settings;

    /// Its surface is a plane that stays where it is.
    bool isCalm() const { return bounds.isLevel() || (bounds.still && bounds.isFlat()); }
};

/// Submerged volume over the hull's, 0 to 1.
inline double wetFraction(const Load& load, const Hull& hull) {
    return std::clamp(load.displacement / hull.moments.volume, 0.0, 1.0);
}

/// Water and gravity as they act on one body at one moment.
class WaterLoad final : public LoadField {
public:
    /// Now. `gravity` in m/s^2, as Bullet has it for the body; `airRate`: at which it is slowed wherever it
    /// is, 1/s; `samples`: counts the points at which the water is asked for its surface or head.
    WaterLoad(const WaterNow& water, const BodyDef& def, double mass, const Vec3& gravity, double airRate,
              int& samples)
        : m_water(water),
          m_def(def),
          m_mass(mass),
          m_gravity(gravity),
          m_airRate(airRate),
          m_time(water.time),
          m_samples(samples) {}

    /// The same `seconds` later, or earlier if below zero.
    WaterLoad after(double seconds) const {
        WaterLoad other = *this;
        other.m_time += seconds;
        return other;
    }

    Vec3 up() const override { return m_water.field.frame().upWorld(); }
    bool isCalm() const override { return m_water.isCalm(); }
    Load at(const Pose& pose, Mat6* stiffness = nullptr) const override;

    /// N
    Vec3 weight() const { return m_mass * m_gravity; }

private:
    double gravitationalEnergyAt(const Pose& pose) const;

    const WaterNow& m_water;
    const BodyDef& m_def;
    double m_mass;
    Vec3 m_gravity;
    double m_airRate;
    double m_time;
    int& m_samples;
};

}  // namespace bullet_buoyancy
