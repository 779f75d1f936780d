#include "bullet_buoyancy/bullet/borrowed_settings.h"

#include "bullet_buoyancy/motion/damping.h"

namespace bullet_buoyancy {

namespace {

constexpr int gyroscopicFlags = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

}  // namespace

void BorrowedSettings::borrow(btRigidBody& body) {
    const double linear = double(body.getLinearDamping()), angular = double(body.getAngularDamping());
    if (linear != 0) {
        m_linearDamping = linear;
        m_linearDampingRate = dampingRate(1 - linear, 1);
    }
    if (angular != 0) m_angularDamping = angular;
    if (linear != 0 || angular != 0) body.setDamping(0, 0);
    if (const int flags = body.getFlags() & gyroscopicFlags) {
        m_gyroscopicFlags |= flags;
        body.setFlags(body.getFlags() & ~gyroscopicFlags);
    }
}

bool BorrowedSettings::isAll(const btRigidBody& body) const {
    return body.getLinearDamping() == 0 && body.getAngularDamping() == 0 &&
           !(body.getFlags() & gyroscopicFlags);
}

void BorrowedSettings::giveBack(btRigidBody& body) const {
    body.setDamping(btScalar(m_linearDamping), btScalar(m_angularDamping));
    body.setFlags((body.getFlags() & ~gyroscopicFlags) | m_gyroscopicFlags);
}

}  // namespace bullet_buoyancy
