#include "soak/boom.h"

#include "bullet_buoyancy/bullet/convert.h"

namespace bullet_buoyancy::demo {

void Boom::pull(scenes::FlotsamScene& scene) const {
    const WaterFrame& frame = scene.water().frame();
    for (const scenes::FlotsamPiece& piece : scene.pieces()) {
        const Vec3 place = frame.pointFromWorld(toEigen(piece.body->getWorldTransform().getOrigin()));
        const Vec2 fromMiddle = place.head<2>();
        const double beyond = fromMiddle.norm() - m_reach;
        if (!(beyond > 0)) continue;
        const double weight = standardGravity / double(piece.body->getInvMass());
        Vec3 force = Vec3::Zero();
        force.head<2>() = -weight * beyond / m_give * fromMiddle.normalized();
        piece.body->applyCentralForce(toBullet(frame.worldFromFrame() * force));
    }
}

}  // namespace bullet_buoyancy::demo
