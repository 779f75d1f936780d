#pragma once

#include "scenes/float_scene.h"
#include "scenes/floating_log.h"
#include "scenes/random_numbers.h"

namespace bullet_buoyancy::scenes {

/// Rounding of one of Bullet's numbers, as a share of it.
inline constexpr double bulletRounding = sizeof(btScalar) == 4 ? 6e-8 : 1.1e-16;

/// Pose, velocities and reported energy are numbers.
bool isFinite(const FloatScene& scene, const btRigidBody& body);

/// The energy of a body that is yet to be stepped, from its pose and Bullet's velocities: kinetic,
/// gravitational and the water's, J.
double energyAtRelease(const FloatScene& scene, const btRigidBody& body, const Hull& hull);

/// How long each of a scene's steps lasts.
class StepLengths {
public:
    /// `shortest` above 0: each as long as chance will have it between that and `stepping.dt` (s), the same
    /// in each run.
    explicit StepLengths(const Stepping& stepping, double shortest = 0)
        : m_stepping(stepping), m_shortest(shortest > 0 ? shortest : stepping.dt) {}

    /// Returns how long the step was, s.
    double step(FloatScene& scene) {
        const double dt = m_random.uniform(m_shortest, m_stepping.dt);
        scene.step(dt, m_stepping.substeps);
        return dt;
    }

private:
    Stepping m_stepping;
    double m_shortest;
    RandomNumbers m_random{1};
};

/// Extremes of a body's motion.
struct Flight {
    double highest;     ///< position of the centre above the water, m
    double mostEnergy;  ///< as reported, J
    double mostMotion;  ///< kinetic energy of a step's mean velocity and spin, as its poses show them, J
    bool finite;
};

/// Steps the scene for `seconds`, or until the body has risen above `ceiling` (m), from where it falls as it
/// came.
Flight observeFlight(FloatScene& scene, const btRigidBody& body, double seconds, double ceiling,
                     StepLengths steps);

struct RestDef {
    double speed;  ///< sqrt(2 kinetic energy / mass), m/s
    double hold;   ///< for so long, s
    double limit;  ///< simulated at most, s
    long maxSteps = 1000000;
};

struct Rest {
    bool reached;
    bool finite;
    double after;        ///< simulated seconds until then, or till the end
    double wetFraction;  ///< mean over the time of rest, so that what is left of a swing does not matter
};

/// Steps the scene until the body is slow for the given time.
Rest awaitRest(FloatScene& scene, const btRigidBody& body, const RestDef& def, StepLengths steps);

/// One step, and how fast the fastest of the bodies has moved in it, as their poses show it: what contacts
/// and joints take from a velocity is not in it. Of the surface, by translation and turn, m/s; infinite if a
/// body is not finite.
double stepAndClock(FloatScene& scene, const std::vector<btRigidBody*>& bodies, const Stepping& stepping);

}  // namespace bullet_buoyancy::scenes
