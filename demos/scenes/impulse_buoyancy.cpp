#include "scenes/impulse_buoyancy.h"

#include <btBulletDynamicsCommon.h>
#include <bullet_buoyancy/bullet_buoyancy.h>

#include <algorithm>

#include "bullet_buoyancy/bullet/convert.h"

namespace bullet_buoyancy::scenes {

namespace {

Vec3 waterVelocityAt(const WaterField& field, const Vec3& pointWorld) {
    const Vec3 point = field.frame().pointFromWorld(pointWorld);
    Vec3 velocity;
    field.sampleVelocity(Eigen::Map<const Eigen::ArrayX3d>(point.data(), 1, 3), 0,
                         Eigen::Map<Eigen::ArrayX3d>(velocity.data(), 1, 3));
    return field.frame().worldFromFrame() * velocity;
}

bool isFinite(const btRigidBody& body) {
    Vec3 sum = toEigen(body.getWorldTransform().getOrigin()) + toEigen(body.getLinearVelocity()) +
               toEigen(body.getAngularVelocity());
    for (int row = 0; row < 3; ++row)
        sum += toEigen(body.getWorldTransform().getBasis()[row]);
    return sum.allFinite();
}

/// Of translation and rotation, J.
double kineticEnergy(const btRigidBody& body, const Vec3& velocity, const Vec3& spin) {
    const Vec3 spinInBody = toPose(body.getWorldTransform()).orientation.conjugate() * spin;
    const Vec3 inertia = toEigen(body.getLocalInertia());
    return velocity.squaredNorm() / double(body.getInvMass()) / 2 +
           inertia.cwiseProduct(spinInBody).dot(spinInBody) / 2;
}

}  // namespace

BodyStatus ImpulseBuoyancy::addBody(btRigidBody& body, const BodyDef& def) {
    BodyStatus status;
    BodyDef complete = def;
    if (!complete.hull) {
        HullResult result = hullFromShape(*body.getCollisionShape());
        status.hull = result.status;
        complete.hull = std::move(result.hull);
    }
    if (complete.hull)
        m_bodies.push_back({&body, complete, {}});
    else
        status.error = BodyError::badHull;
    return status;
}

BodyReport ImpulseBuoyancy::report(const btRigidBody& body) const {
    const auto found = std::find_if(m_bodies.begin(), m_bodies.end(),
                                    [&](const Floating& floating) { return floating.body == &body; });
    return found == m_bodies.end() ? BodyReport() : found->report;
}

void ImpulseBuoyancy::updateAction(btCollisionWorld* world, btScalar dt) {
    const btVector3 gravity = static_cast<btDynamicsWorld*>(world)->getGravity();
    const double alongDown = std::max(0.0, -toEigen(gravity).dot(m_water->frame().upWorld()));
    for (Floating& floating : m_bodies)
        step(floating, alongDown, double(dt));
}

void ImpulseBuoyancy::step(Floating& floating, double gravity, double dt) const {
    btRigidBody& body = *floating.body;
    BodyReport& report = floating.report;
    if (!isFinite(body)) {
        report.state = BodyState::notFinite;
        return;
    }
    const Pose pose = toPose(body.getWorldTransform());
    const HydrostaticResult pressure = evaluateExact(*floating.def.hull, pose, *m_water, {gravity});
    const double wet = std::clamp(pressure.submergedVolume / floating.def.hull->moments.volume, 0.0, 1.0);
    const double share = floating.def.scaleByWetFraction ? wet : (wet > 0 ? 1 : 0);

    const Vec3 velocity = toEigen(body.getLinearVelocity()), spin = toEigen(body.getAngularVelocity());
    const Vec3 flow = waterVelocityAt(*m_water, pose.position + pressure.centreOfBuoyancyFromCom);
    const double drag = share * floating.def.linearDrag * dt,
                 damping = share * floating.def.angularDamping * dt;
    body.applyCentralImpulse(toBullet(dt * pressure.forceWorld));
    body.applyTorqueImpulse(toBullet(dt * pressure.torqueAboutCom));
    body.setLinearVelocity(body.getLinearVelocity() - toBullet(drag * (velocity - flow)));
    body.setAngularVelocity(body.getAngularVelocity() - toBullet(damping * spin));

    // At the pose a body moves by the mean of the velocities before and after it: Bullet's gravity is yet to
    // come.
    const Vec3 weight = toEigen(body.getGravity());
    const Vec3 mean = (velocity + toEigen(body.getLinearVelocity()) + dt * weight) / 2;
    report.state = wet <= 0 ? BodyState::dry : (wet < 1 ? BodyState::floating : BodyState::submerged);
    report.velocity = toBullet(mean);
    report.submergedVolume = pressure.submergedVolume;
    report.wetFraction = wet;
    report.kineticEnergy = kineticEnergy(body, mean, (spin + toEigen(body.getAngularVelocity())) / 2);
    report.gravitationalEnergy =
        -weight.dot(pose.position - m_water->frame().originWorld()) / double(body.getInvMass());
    report.waterPotentialEnergy = pressure.potentialEnergy;
}

}  // namespace bullet_buoyancy::scenes
