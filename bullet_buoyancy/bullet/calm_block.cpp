#include "bullet_buoyancy/bullet/calm_block.h"

#include <limits>

namespace bullet_buoyancy {

namespace {

LevelWater levelWater(const WaterNow& water) {
    const Vec3 up = water.field.frame().upWorld(), &origin = water.field.frame().originWorld();
    return {{up.x(), up.y(), up.z()},
            {origin.x(), origin.y(), origin.z()},
            water.field.density() * water.gravity};
}

}  // namespace

CalmBlock::CalmBlock(const WaterNow& water, double dt)
    : m_water(water), m_dt(dt), m_level(levelWater(water)) {}

void CalmBlock::add(FloatingBody& body) {
    body.put(m_rows, m_count);
    m_bodies[m_count++] = &body;
    if (m_count == blockSize) step();
}

void CalmBlock::step() {
    if (m_count == 0) return;
    for (int lane = m_count; lane < blockSize; ++lane)
        m_bodies[0]->put(m_rows, lane);
    constexpr double rounding = std::numeric_limits<btScalar>::epsilon();
    const PoseRows& poses = m_rows.arrivals.pose;
    m_rows.displacement.take(m_level, poses, m_water.settings.precision);
    calmLoadKernels().load(m_level, poses, m_rows.displacement.hulls(), m_rows.floating,
                           m_rows.displacement.rows(), m_rows.loads);
    calmStepKernels().step(m_rows.arrivals, m_rows.loads, m_water.gravity, m_dt, m_rows.steps);
    const HandoverKernels& handover = handoverKernels();
    handover.take(poses, m_dt, rounding, m_rows.returns);
    handover.give(poses, m_rows.returns, m_rows.steps.departing.velocity, m_rows.steps.target, m_dt, rounding,
                  m_rows.gifts);
    for (int lane = 0; lane < m_count; ++lane)
        if (m_rows.returns.isUndisturbed.lane[lane] > 0 && m_rows.steps.isCalm.lane[lane] > 0)
            m_bodies[lane]->stepCalmly(m_rows, lane, m_water, m_dt);
        else
            m_bodies[lane]->step(m_water, m_dt);
    m_count = 0;
}

}  // namespace bullet_buoyancy
