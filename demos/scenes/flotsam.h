#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "scenes/random_numbers.h"

namespace bullet_buoyancy::scenes {

/// What floats about.
enum class Flotsam { crate, barrel, buoy, fender, spar, plank, lump, raft, boat };

inline constexpr int flotsamKinds = int(Flotsam::boat) + 1;

const char* nameOf(Flotsam kind);

/// One piece, of random size and density.
struct FlotsamPiece {
    Flotsam kind;
    std::shared_ptr<const Hull> hull;
    double ratio;  ///< of its density to the water's, by its hull's volume
    std::vector<std::unique_ptr<btCollisionShape>> shapes;  ///< the first is the body's, the others its parts
    std::unique_ptr<btRigidBody> body;
};

struct FlotsamDef {
    int bodies = 60;
    std::uint64_t seed = 1;
    double area = 4;  ///< of the sea, m^2 a body
    BuoyancySettings buoyancy;
};

/// Crates, barrels, buoys, fenders, spars, planks, lumps of many corners, rafts of barrels and a boat,
/// dropped from above into any water: a Bullet world of its own, the same for the same seed. The boat is in
/// the middle, the first of the pieces.
class FlotsamScene {
public:
    /// The water must outlive the scene; gravity is against its up.
    FlotsamScene(const FlotsamDef& def, const WaterField& water);
    ~FlotsamScene();
    FlotsamScene(const FlotsamScene&) = delete;
    FlotsamScene& operator=(const FlotsamScene&) = delete;

    /// One substep of `dt` (s).
    void step(double dt);

    double time() const { return m_buoyancy.time(); }  ///< s
    const btDiscreteDynamicsWorld& world() const { return m_world; }
    const WaterField& water() const { return m_water; }
    BuoyancyAction& buoyancy() { return m_buoyancy; }
    const BuoyancyAction& buoyancy() const { return m_buoyancy; }
    const std::vector<FlotsamPiece>& pieces() const { return m_pieces; }

private:
    void add(FlotsamPiece piece);
    Vec3 freePlace(RandomNumbers& random, double radius, double reach, double height) const;

    const WaterField& m_water;
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    BuoyancyAction m_buoyancy;
    std::vector<FlotsamPiece> m_pieces;
};

}  // namespace bullet_buoyancy::scenes
