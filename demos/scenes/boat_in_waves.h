#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "scenes/boat.h"
#include "scenes/sea.h"

namespace bullet_buoyancy::scenes {

struct VoyageDef {
    double duration = 600;   ///< of the record, s
    double step = 1.0 / 60;  ///< s
    /// Simulated before the record begins, s: the boat is released at rest at the waves' height. The record's
    /// time, which is that of the water, starts at 0 all the same.
    double settling = 60;
    BuoyancySettings buoyancy{PressureModel::waveDynamic, BuoyancySettings().tolerance};
    double linearDrag = 3;         ///< see BodyDef, 1/s
    double angularDamping = 1.01;  ///< 1/s

    /// Natural period in surge, sway and yaw of the springs that hold the boat, s: many times that of the
    /// waves; infinite: it drifts. They are pretensioned against the drag of the current on the boat at rest;
    /// what damps them is the water.
    double mooringPeriod = 60;
};

/// The boat at one moment. Heave, surge and sway are those of its centre of mass from where it rests in still
/// water. Of the angles, yaw is about the vertical, to port; pitch about the horizontal across the boat, bow
/// up; roll about its length, to starboard.
struct VoyageSample {
    double time;                ///< s
    double elevation;           ///< of the surface at the probe, the boat's place in still water, m
    double slope;               ///< of the water along the boat, as at its two ends, rad
    double surge, sway, heave;  ///< world x, y, z, m
    double roll, pitch, yaw;    ///< rad
    double errorBound;          ///< of the force of the water, over the boat's weight
    int waterSamples;           ///< asked of the water in this step
};

enum class Mishap {
    none,
    refused,    ///< the action does not take the boat
    notFinite,  ///< position or force
    capsized,   ///< its mast points below the horizon
    sunk,       ///< wholly under water for longer than a wave
};

struct Voyage {
    std::vector<VoyageSample> samples;  ///< one a step, until a mishap or an interruption
    Mishap mishap = Mishap::none;
    double clockPerStep = 0;  ///< s of real time in a step of Bullet's world, mean
};

/// A Bullet world with one boat in a sea, its bow along x.
class BoatInWaves {
public:
    BoatInWaves(const Boat& boat, Sea& sea, const VoyageDef& def);
    ~BoatInWaves();
    BoatInWaves(const BoatInWaves&) = delete;
    BoatInWaves& operator=(const BoatInWaves&) = delete;

    void step();

    double time() const { return m_time; }  ///< of the water, s
    const btDiscreteDynamicsWorld& world() const { return m_world; }

    VoyageSample sample() const;
    Mishap mishap() const { return m_mishap; }

    Pose pose() const;
    BodyReport report() const { return m_buoyancy.report(*m_body); }

private:
    void placeBody();
    void pullMooring();
    void look();
    double slopeAlong(const Pose& pose) const;

    Boat m_boat;
    Sea& m_sea;
    VoyageDef m_def;
    double m_time = 0, m_underWater = 0;  // s
    Mishap m_mishap = Mishap::none;
    Vec3 m_pretension = Vec3::Zero();  // N
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    BuoyancyAction m_buoyancy;
    std::unique_ptr<btCollisionShape> m_shape;
    std::unique_ptr<btRigidBody> m_body;
};

/// `look` is called after each step, and told whether that is of the record.
Voyage sail(
    const Boat& boat, Sea& sea, const VoyageDef& def,
    const std::function<void(const BoatInWaves&, bool)>& look = [](const BoatInWaves&, bool) {});

/// One column of a record.
std::vector<double> series(const Voyage& voyage, double VoyageSample::*quantity);

}  // namespace bullet_buoyancy::scenes
