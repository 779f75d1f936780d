#include "recording/flotsam_cast.h"

namespace bullet_buoyancy::recording {

using namespace scenes;

namespace {

Look lookOf(Flotsam kind) {
    switch (kind) {
        case Flotsam::crate:
            return Look::wood;
        case Flotsam::barrel:
            return Look::blue;
        case Flotsam::buoy:
            return Look::orange;
        case Flotsam::fender:
            return Look::yellow;
        case Flotsam::spar:
            return Look::darkWood;
        case Flotsam::plank:
        case Flotsam::raft:
            return Look::paleWood;
        case Flotsam::lump:
            return Look::stone;
        case Flotsam::boat:
            break;
    }
    return Look::red;
}

}  // namespace

Cast castOf(const FlotsamScene& scene, const btRigidBody& body) {
    for (const FlotsamPiece& piece : scene.pieces())
        if (piece.body.get() == &body) return {nameOf(piece.kind), lookOf(piece.kind), piece.hull};
    return {};
}

WorldView viewOf(const FlotsamScene& scene) {
    return {scene.world(), scene.water(), scene.time(),
            [&scene](const btRigidBody& body) { return scene.buoyancy().report(body); }};
}

}  // namespace bullet_buoyancy::recording
