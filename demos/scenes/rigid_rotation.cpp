#include "scenes/rigid_rotation.h"

namespace bullet_buoyancy::scenes {

namespace {

struct Rate {
    Eigen::Vector4d orientation;
    Vec3 spin;
};

Rate rateOf(const FreeRotation& rotation, const Vec3& inertia) {
    const Vec3& w = rotation.spin;
    const Eigen::Quaterniond turning = rotation.orientation * Eigen::Quaterniond(0, w.x(), w.y(), w.z());
    return {turning.coeffs() / 2, inertia.cwiseProduct(w).cross(w).cwiseQuotient(inertia)};
}

FreeRotation advanced(const FreeRotation& rotation, const Rate& rate, double dt) {
    FreeRotation result;
    result.orientation.coeffs() = rotation.orientation.coeffs() + dt * rate.orientation;
    result.spin = rotation.spin + dt * rate.spin;
    return result;
}

}  // namespace

FreeRotation rotateFreely(FreeRotation rotation, const Vec3& inertia, double seconds, int steps) {
    const double dt = seconds / steps;
    for (int i = 0; i < steps; ++i) {
        const Rate k1 = rateOf(rotation, inertia);
        const Rate k2 = rateOf(advanced(rotation, k1, dt / 2), inertia);
        const Rate k3 = rateOf(advanced(rotation, k2, dt / 2), inertia);
        const Rate k4 = rateOf(advanced(rotation, k3, dt), inertia);
        const Rate mean{(k1.orientation + 2 * k2.orientation + 2 * k3.orientation + k4.orientation) / 6,
                        (k1.spin + 2 * k2.spin + 2 * k3.spin + k4.spin) / 6};
        rotation = advanced(rotation, mean, dt);
        rotation.orientation.normalize();
    }
    return rotation;
}

}  // namespace bullet_buoyancy::scenes
