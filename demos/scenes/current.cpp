#include "scenes/current.h"

#include <algorithm>
#include <cmath>

namespace bullet_buoyancy::scenes {

CurrentResult driftInCurrent(const DriftDef& def) {
    SceneDef sceneDef;
    sceneDef.flowVelocityWorld = {def.current, 0, 0};
    sceneDef.floater = def.floater;
    FloatScene scene(sceneDef);
    Pose pose;
    pose.position.z() = def.ratio < 1 ? 0.5 - def.ratio : -10;
    BodyDef drag;
    drag.linearDrag = def.linearDrag;
    btRigidBody& crate = scene.addFloatingBox({1, 1, 1}, def.ratio, pose, drag);
    crate.setLinearVelocity({btScalar(def.startSpeed), 0, 0});

    const double start = def.startSpeed - def.current;
    CurrentResult result{0, 0, true};
    while (scene.time() < def.seconds && result.finite) {
        scene.step(def.stepping.dt, def.stepping.substeps);
        result.finite = isFinite(scene, crate);
        const double relative = (double(scene.report(crate).velocity.x()) - def.current) / start;
        result.overshoot = std::max(result.overshoot, -relative);
        result.remaining = std::abs(relative);
    }
    return result;
}

}  // namespace bullet_buoyancy::scenes
