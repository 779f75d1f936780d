#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <optional>
#include <unordered_map>

#include "bullet_buoyancy/bullet/body_report.h"
#include "recording/film.h"
#include "scenes/float_scene.h"

namespace bullet_buoyancy::recording {

/// What a body of a world is seen as.
struct Cast {
    std::string name;
    Look look;
    std::shared_ptr<const Hull> hull;  ///< null: it is not seen
};

/// By its collision shape alone.
Cast castByShape(const btRigidBody& body);

/// A world at one moment.
struct WorldView {
    const btDiscreteDynamicsWorld& world;
    const WaterField& water;
    double time;  ///< of the water, s
    std::function<BodyReport(const btRigidBody&)> report;
};

/// The film of a Bullet world: of all bodies in it, those that come later and those that go included.
class WorldFilm {
public:
    using Casting = std::function<Cast(const btRigidBody&)>;

    explicit WorldFilm(const FilmDef& def, Casting casting = castByShape)
        : m_def(def), m_casting(std::move(casting)) {}

    /// To be called after each step; takes a frame where one is due. The first look decides where the water
    /// is seen: about the bodies that move. Of several worlds in turn only the first is filmed, as far as
    /// their times begin anew.
    void look(const WorldView& view);
    void look(const scenes::FloatScene& scene);

    /// Null as long as nothing was seen.
    const Film* film() const { return m_film ? &*m_film : nullptr; }

private:
    void show(const btRigidBody& body, const WorldView& view);

    FilmDef m_def;
    Casting m_casting;
    std::optional<Film> m_film;
    double m_time = 0;
    bool m_isOver = false;
    std::unordered_map<const btRigidBody*, std::optional<std::size_t>> m_numbers;  // in the film
};

}  // namespace bullet_buoyancy::recording
