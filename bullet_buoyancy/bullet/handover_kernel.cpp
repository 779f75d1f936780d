// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/bullet/handover_kernels.h"
#include "bullet_buoyancy/core/body_lanes.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

/// Gravity is in the force, and nobody's but it.
Outcomes isGravityAlone(const Vectors& external, const Vectors& ofGravity, double rounding) {
    const Vectors byUser = external - ofGravity;
    const Numbers square = ofGravity.dot(ofGravity), limit = 64.0 * rounding * rounding * square;
    const Outcomes acted = external.dot(ofGravity) > 0.5 * square,
                   alone = areWithin(byUser.times(byUser), limit);
    return acted & alone;
}

Outcomes isPose(const Vectors (&axes)[3], const Vectors& position, const Quaternions& orientation,
                const Vectors& target, const Numbers& travel, double rounding) {
    const Rotations targets(orientation);
    const Numbers ofAxes = spread(4 * rounding),
                  ofPosition = 8 * rounding * (largest(position) + travel + 1e-3);
    const Outcomes x = areWithin(axes[0] - targets.x, ofAxes), y = areWithin(axes[1] - targets.y, ofAxes),
                   z = areWithin(axes[2] - targets.z, ofAxes),
                   isThere = areWithin(position - target, ofPosition);
    return x & y & z & isThere;
}

void take(const PoseRows& targets, double dt, double rounding, ReturnRows& returns) {
    const Numbers none{}, one = spread(1.0), time = spread(dt);
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const Vectors velocity = load(returns.velocity, lane), given = load(returns.given, lane);
        const Vectors external = time * load(returns.inverseMass, lane) * load(returns.force, lane);
        const Vectors ofGravity = time * load(returns.gravity, lane);
        const Numbers limit = 4 * rounding * (largest(given) + largest(external));
        const Numbers travel = time * (absolute(velocity.x) + absolute(velocity.y) + absolute(velocity.z));
        const Vectors axes[3] = {load(returns.axes[0], lane), load(returns.axes[1], lane),
                                 load(returns.axes[2], lane)};
        const Outcomes isFree = areWithin(velocity - (given + external), limit),
                       isHeavy = isGravityAlone(external, ofGravity, rounding),
                       isThere = isPose(axes, load(returns.position, lane), load(targets.orientation, lane),
                                        load(targets.position, lane), travel, rounding);
        const Outcomes isUndisturbed = isFree & isHeavy & isThere;
        store(isUndisturbed ? one : none, returns.isUndisturbed, lane);
    }
}

/// See rotationVector: of small angles.
Vectors smallRotationVector(const Quaternions& q) {
    const Numbers square = q.vec.dot(q.vec);
    const Numbers angleOverSine =
        2.0 * (1.0 + square * (1. / 6 + square * (3. / 40 + square * (5. / 112 + square * (35. / 1152)))));
    return (q.w < Numbers{} ? -angleOverSine : angleOverSine) * q.vec;
}

void give(const PoseRows& poses, const ReturnRows& returns, const VectorRows& departure,
          const PoseRows& targets, double dt, double rounding, GiftRows& gifts) {
    const Numbers none{}, time = spread(dt), perTime = spread(1 / dt);
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const Vectors bullets = load(returns.position, lane);
        const Vectors difference = load(poses.position, lane) - bullets;
        const Numbers tolerance = 2 * rounding * (largest(bullets) + 1e-3);
        const Numbers rate = largest(difference) > tolerance ? 1.0 / load(returns.longestStep, lane) : none;
        const Vectors correction = rate * difference;
        store(correction, gifts.correction, lane);
        store(load(departure, lane) + correction - time * load(returns.gravity, lane), gifts.velocity, lane);
        store(perTime * smallRotationVector(load(targets.orientation, lane) *
                                            load(poses.orientation, lane).conjugate()),
              gifts.spin, lane);
    }
}

}  // namespace

extern const HandoverKernels handoverKernels;

const HandoverKernels handoverKernels = {take, give};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
