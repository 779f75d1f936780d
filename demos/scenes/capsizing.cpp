#include "scenes/capsizing.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"

namespace bullet_buoyancy::scenes {

namespace {

const Vec3 size(6, 2, 1);
constexpr double ratio = 0.5;

/// A box whose middle lies below the body's origin, its centre of mass.
class LoweredBox final : public btCompoundShape {
public:
    explicit LoweredBox(double drop) : m_box(toBullet(size / 2)) {
        addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(-drop))), &m_box);
    }

private:
    btBoxShape m_box;
};

/// GM = KB + BM - KG of a box of that draft.
double metacentricHeight(double raised) {
    const double draft = ratio * size.z();
    return draft / 2 + size.y() * size.y() / (12 * draft) - (size.z() / 2 + raised);
}

}  // namespace

CapsizeResult heelHull(const CapsizeDef& def) {
    SceneDef sceneDef;
    sceneDef.floater = def.floater;
    FloatScene scene(sceneDef);
    Pose pose;
    pose.position.z() = (0.5 - ratio) * size.z() + def.raised;
    pose.orientation = Eigen::AngleAxisd(def.heel, Vec3::UnitX());
    const double mass = ratio * scene.water().density() * size.prod();
    const Vec3 squares = size.cwiseProduct(size);
    const Vec3 inertia = mass / 12 * (Vec3::Constant(squares.sum()) - squares);
    btRigidBody& hull = scene.addBody(std::make_unique<LoweredBox>(def.raised), mass, inertia, pose);
    scene.floatBody(hull);

    CapsizeResult result{metacentricHeight(def.raised), 0, 0, true};
    while (scene.time() < def.seconds && result.finite) {
        scene.step(def.stepping.dt, def.stepping.substeps);
        result.finite = isFinite(scene, hull);
        result.endHeel = std::acos(std::clamp(upInBody(hull, scene.water()).z(), -1.0, 1.0));
        result.mostHeel = std::max(result.mostHeel, result.endHeel);
    }
    return result;
}

}  // namespace bullet_buoyancy::scenes
