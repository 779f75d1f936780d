#include "bullet_buoyancy/bullet/water_load.h"

#include "bullet_buoyancy/hydrodynamics/wet_rate.h"
#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "bullet_buoyancy/motion/energy.h"

namespace bullet_buoyancy {

namespace {

Vec3 waterVelocityAt(const WaterField& field, const Vec3& pointWorld, double time) {
    const Vec3 point = field.frame().pointFromWorld(pointWorld);
    Vec3 velocity;
    field.sampleVelocity(Eigen::Map<const Eigen::ArrayX3d>(point.data(), 1, 3), time,
                         Eigen::Map<Eigen::ArrayX3d>(velocity.data(), 1, 3));
    return field.frame().worldFromFrame() * velocity;
}

}  // namespace

Load WaterLoad::at(const Pose& pose, Mat6* stiffness) const {
    HydrostaticQuery query{m_water.gravity, m_time, m_water.settings.pressure, m_water.settings.tolerance};
    query.precision = m_water.settings.precision;
    query.stiffness = stiffness != nullptr;
    const HydrostaticResult pressure = evaluate(*m_def.hull, pose, m_water.field, query);
    m_samples += pressure.waterSamples;
    if (stiffness) *stiffness = *pressure.stiffness;

    Load load;
    load.force = pressure.forceWorld + weight();
    load.torque = pressure.torqueAboutCom;
    const double gravitational = gravitationalEnergyAt(pose);
    load.potential = pressure.potentialEnergy + gravitational;
    constexpr double operations = 16;  // that round, about
    load.potentialRounding = operations * std::numeric_limits<double>::epsilon() *
                             (std::abs(pressure.potentialEnergy) + std::abs(gravitational));
    load.displacement = pressure.submergedVolume;
    load.centreFromCom = pressure.centreOfBuoyancyFromCom;
    load.forceErrorBound = pressure.forceErrorBound;
    const double wet = wetFraction(load, *m_def.hull);
    const double wetDrag = wetRate(m_def.linearDrag, wet, m_def.scaleByWetFraction);
    load.dragRate = wetDrag + m_airRate;
    load.dampingRate = wetRate(m_def.angularDamping, wet, m_def.scaleByWetFraction);
    if (wetDrag > 0 && !m_water.bounds.still)
        load.mediumVelocity = wetDrag / load.dragRate *
                              waterVelocityAt(m_water.field, pose.position + load.centreFromCom, m_time);
    return load;
}

/// Zero at the water frame's origin, J.
double WaterLoad::gravitationalEnergyAt(const Pose& pose) const {
    return gravitationalEnergy(m_mass, m_gravity, pose.position - m_water.field.frame().originWorld());
}

}  // namespace bullet_buoyancy
