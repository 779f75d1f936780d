#pragma once

#include "bullet_buoyancy/motion/free_flight.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

inline Inertia withInertia(double mass, const Vec3& principal) {
    Inertia inertia;
    inertia.mass = mass;
    inertia.principal = principal;
    inertia.inversePrincipal = principal.cwiseInverse();
    return inertia;
}

inline Inertia ofBall(double mass, double radius) {
    return withInertia(mass, Vec3::Constant(0.4 * mass * radius * radius));
}

inline Inertia ofBox(double mass, const Vec3& halfSize) {
    const Vec3 squares = mass / 3 * halfSize.cwiseAbs2();
    return withInertia(mass, Vec3::Constant(squares.sum()) - squares);
}

inline Inertia randomInertia(Random& random) {
    const double x = random.uniform(0.1, 1), y = random.uniform(0.1, 1), z = random.uniform(0.1, 1);
    return ofBox(random.uniform(1, 10), {x, y, z});
}

/// Of a box with the half size 0.1 m to 1 m, at some 5 m/s and 5 rad/s.
inline Motion randomMotion(Random& random, const Inertia& inertia) {
    Motion motion;
    motion.pose = {random.inCube(1), random.orientation()};
    motion.velocity = random.inCube(5);
    motion.setSpin(inertia, random.inCube(5));
    return motion;
}

/// Still, at a height above z = 0.
inline Motion stillAt(double height) {
    Motion motion;
    motion.pose.position.z() = height;
    return motion;
}

}  // namespace bullet_buoyancy::test
