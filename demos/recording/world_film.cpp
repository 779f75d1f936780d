#include "recording/world_film.h"

#include <algorithm>

#include "bullet_buoyancy/bullet/convert.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"

namespace bullet_buoyancy::recording {

namespace {

const btRigidBody* rigidBody(const btCollisionObject* object) {
    return btRigidBody::upcast(object);
}

/// A rectangle about the bodies that move, with some water around them.
Stage stageOf(const WorldView& view) {
    constexpr double around = 1.1, roomBeside = 0.5, narrowest = 0.4;
    const WaterFrame& frame = view.water.frame();
    Vec2 low = Vec2::Constant(1e9), high = -low;
    double largest = 0;
    const auto& objects = view.world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        const btRigidBody* body = rigidBody(objects[i]);
        if (!body || body->isStaticObject()) continue;
        btVector3 centre;
        btScalar radius = 0;
        body->getCollisionShape()->getBoundingSphere(centre, radius);
        const Vec3 place = frame.pointFromWorld(toEigen(body->getWorldTransform() * centre));
        low = low.cwiseMin(place.head<2>() - Vec2::Constant(double(radius)));
        high = high.cwiseMax(place.head<2>() + Vec2::Constant(double(radius)));
        largest = std::max(largest, double(radius));
    }
    if (largest == 0) return {};
    const Vec2 reach = around * (high - low) / 2 + Vec2::Constant(roomBeside * largest);
    return {(low + high) / 2, reach.cwiseMax(narrowest * reach.maxCoeff())};
}

struct Appearance {
    const char* name;
    Look look;
};

Appearance appearanceOf(const btCollisionShape& shape) {
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE:
            return {"box", Look::wood};
        case SPHERE_SHAPE_PROXYTYPE:
            return {"ball", Look::orange};
        case CAPSULE_SHAPE_PROXYTYPE:
            return {"capsule", Look::yellow};
        case CYLINDER_SHAPE_PROXYTYPE:
            return {"cylinder", Look::blue};
        case CONVEX_HULL_SHAPE_PROXYTYPE:
            return {"hull", Look::stone};
        case COMPOUND_SHAPE_PROXYTYPE:
            return {"compound", Look::paleWood};
        default:
            return {"body", Look::white};
    }
}

}  // namespace

Cast castByShape(const btRigidBody& body) {
    Appearance seen = appearanceOf(*body.getCollisionShape());
    if (body.isStaticObject()) seen = {"ground", Look::sand};
    return {seen.name, seen.look, hullFromShape(*body.getCollisionShape()).hull};
}

void WorldFilm::look(const WorldView& view) {
    m_isOver = m_isOver || (m_film && view.time < m_time);
    m_time = view.time;
    if (m_isOver) return;
    if (!m_film) m_film.emplace(m_def, view.water.frame(), stageOf(view));
    if (!m_film->isDue(view.time)) return;
    m_film->beginFrame(view.time, view.water);
    const auto& objects = view.world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (const btRigidBody* body = rigidBody(objects[i])) show(*body, view);
}

void WorldFilm::look(const scenes::FloatScene& scene) {
    look({scene.world(), scene.water(), scene.time(),
          [&](const btRigidBody& body) { return scene.report(body); }});
}

void WorldFilm::show(const btRigidBody& body, const WorldView& view) {
    const auto [known, isNew] = m_numbers.try_emplace(&body);
    if (isNew) {
        Cast cast = m_casting(body);
        if (cast.hull)
            known->second = m_film->addBody(cast.name + ' ' + std::to_string(m_film->bodies().size() + 1),
                                            cast.look, cast.hull);
    }
    if (!known->second) return;
    WaterForce force;
    if (m_def.forces && !body.isStaticOrKinematicObject()) {
        const BodyReport report = view.report(body);
        const Hull& hull = *m_film->bodies()[*known->second].hull;
        const double weight =
            view.water.density() * double(view.world.getGravity().length()) * hull.moments.volume;
        force.centre = toEigen(report.centreOfBuoyancyWorld);
        if (weight > 0) force.force = toEigen(report.forceWorld) / weight;
    }
    m_film->show(*known->second, toPose(body.getWorldTransform()), force);
}

}  // namespace bullet_buoyancy::recording
