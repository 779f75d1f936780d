#include "support/random_cases.h"

namespace bullet_buoyancy::test {

Vec3 Random::inCube(double halfSize) {
    const double x = uniform(-halfSize, halfSize), y = uniform(-halfSize, halfSize);
    return {x, y, uniform(-halfSize, halfSize)};
}

Vec3 Random::direction() {
    while (true) {
        const Vec3 point = inCube(1);
        if (const double length = point.norm(); length > 0.1 && length < 1) return point / length;
    }
}

Eigen::Quaterniond Random::orientation() {
    while (true) {
        Eigen::Vector4d
            point;  // filled one by one: the order in which arguments are evaluated is the compiler's
        for (double& coordinate : point)
            coordinate = uniform(-1, 1);
        if (const double length = point.norm(); length > 0.1 && length < 1)
            return Eigen::Quaterniond(Eigen::Vector4d(point / length));
    }
}

}  // namespace bullet_buoyancy::test
