// Floats a crate for a minute and checks its draft: a 1 m cube of 100 kg in water of 1000 kg/m^3 floats face
// up, 0.1 m deep.

#include <btBulletDynamicsCommon.h>
#include <bullet_buoyancy/bullet_buoyancy.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>

#ifdef PACKAGE_VERSION  // what the package says of itself
static_assert(std::string_view(BULLET_BUOYANCY_VERSION) == PACKAGE_VERSION);
#endif
static_assert(BULLET_BUOYANCY_VERSION_NUMBER >= 100, "0.1.0 or later");

int main() {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    auto world = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher, &broadphase, &solver, &configuration);
    world->setGravity(btVector3(0, btScalar(-9.81), 0));

    btBoxShape box(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
    const btScalar mass = 100;
    btVector3 inertia;
    box.calculateLocalInertia(mass, inertia);
    auto crate = std::make_unique<btRigidBody>(mass, nullptr, &box, inertia);
    world->addRigidBody(crate.get());

    // [snippet]
    bullet_buoyancy::FlatWater sea(bullet_buoyancy::WaterFrame::yUp());  // or zUp(), or any origin and up
    bullet_buoyancy::BuoyancyAction buoyancy(sea);  // one action floats any number of bodies
    const auto status = buoyancy.addBody(*crate);   // its hull is read from its collision shape
    if (!status) std::puts(status.describe().c_str());
    world->addAction(&buoyancy);

    for (int frame = 0; frame < 60 * 60; ++frame)
        world->stepSimulation(1 / 60.f);

    const auto& report = buoyancy.report(*crate);
    std::printf("%.3f m^3 under water\n", report.submergedVolume);
    // [end]

    const double draft = 0.5 - double(crate->getWorldTransform().getOrigin().y());
    std::printf("draft: %.4f m\n", draft);
    const bool floats = std::abs(draft - 0.1) < 0.01 && std::abs(report.submergedVolume - 0.1) < 0.01;

    world->removeAction(&buoyancy);
    world->removeRigidBody(crate.get());
    return floats ? 0 : 1;
}
