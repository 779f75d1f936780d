#pragma once

#include "bullet_buoyancy/bullet/body_def.h"
#include "bullet_buoyancy/motion/load.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy {

/// The water as it meets the bodies in one substep.
struct WaterNow {
    const WaterField& field;
    WaterBounds bounds;
    double gravity;  ///< of the world, along the water frame's down, m/s^2
    double time;     ///< s
};

/// Water and gravity as they act on one body.
class WaterLoad final : public LoadField {
public:
    /// `gravity` in m/s^2, as Bullet has it for the body; `airRate`: at which it is slowed wherever it is,
    /// 1/s.
    WaterLoad(const WaterNow& water, const BodyDef& def, double mass, const Vec3& gravity, double airRate)
        : m_water(water), m_def(def), m_mass(mass), m_gravity(gravity), m_airRate(airRate) {}

    Vec3 up() const override { return m_water.field.frame().upWorld(); }
    bool isCalm() const override { return true; }
    Load at(const Pose& pose, Mat6* stiffness = nullptr) const override;

    /// N
    Vec3 weight() const { return m_mass * m_gravity; }

    /// Zero at the water frame's origin, J.
    double gravitationalEnergyAt(const Pose& pose) const;

    /// Submerged volume over the hull's, 0 to 1.
    double wetFraction(const Load& load) const;

private:
    const WaterNow& m_water;
    const BodyDef& m_def;
    double m_mass;
    Vec3 m_gravity;
    double m_airRate;
};

}  // namespace bullet_buoyancy
