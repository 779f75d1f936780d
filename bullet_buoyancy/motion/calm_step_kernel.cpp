// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/core/body_lanes.h"
#include "bullet_buoyancy/motion/calm_limits.h"
#include "bullet_buoyancy/motion/calm_step_kernels.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

struct Moving {
    Vectors velocity, momentum, spin;

    static Moving from(const MovingRows& rows, int lane) {
        return {load(rows.velocity, lane), load(rows.momentum, lane), load(rows.spin, lane)};
    }
    void putInto(MovingRows& rows, int lane) const {
        store(velocity, rows.velocity, lane);
        store(momentum, rows.momentum, lane);
        store(spin, rows.spin, lane);
    }
};

struct Dissipated {
    Numbers byDrag, byDamping;

    void putInto(DissipationRows& rows, int lane) const {
        store(byDrag, rows.byDrag, lane);
        store(byDamping, rows.byDamping, lane);
    }
};

/// Half a step of a DampedStep, by its series.
struct Damped {
    Numbers rate, decay, gain, gainOfTravel;
    Outcomes isInSeries;

    Damped(const Numbers& itsRate, const Numbers& step) : rate(itsRate) {
        const Numbers x = rate * step, y = x * x;
        const Numbers even = 1. / 2 + y * (1. / 24 + y * (1. / 720 + y * (1. / 40320 + y * (1. / 3628800))));
        const Numbers odd =
            1. / 6 + y * (1. / 120 + y * (1. / 5040 + y * (1. / 362880 + y * (1. / 39916800))));
        const Numbers second = even - x * odd, share = 1.0 - x * second;
        decay = 1.0 - x * share;
        gain = step * share;
        gainOfTravel = step * step * second;
        isInSeries = x < spread(dampingSeriesEnds);
    }

    Vectors advance(const Vectors& value, const Vectors& load) const { return decay * value + gain * load; }
    Vectors travel(const Vectors& value, const Vectors& load) const {
        return gain * value + gainOfTravel * load;
    }
    /// Rounding of what is nothing without damping.
    Numbers unlessUndamped(const Numbers& energy) const { return rate > Numbers{} ? energy : Numbers{}; }
};

/// See Inertia.
struct Bodies {
    Numbers mass;
    Vectors inversePrincipal;

    Vectors spin(const Rotations& axes, const Vectors& momentum) const {
        return axes * inversePrincipal.times(axes.transposed(momentum));
    }
    Numbers kineticEnergy(const Moving& m) const {
        return mass * m.velocity.dot(m.velocity) * 0.5 + m.momentum.dot(m.spin) * 0.5;
    }
};

/// See Kick, in a medium at rest.
struct HalfKick {
    Damped linear, angular;
    Vectors torque, acceleration, angularAcceleration;

    Dissipated apply(Moving& moving, const Numbers& mass) const {
        const Moving before = moving;
        moving.velocity = linear.advance(before.velocity, acceleration);
        moving.spin = angular.advance(before.spin, angularAcceleration);
        moving.momentum = angular.advance(before.momentum, torque);
        const Numbers byDrag =
            mass * (acceleration.dot(linear.travel(before.velocity, acceleration)) -
                    (moving.velocity.dot(moving.velocity) - before.velocity.dot(before.velocity)) * 0.5);
        const Numbers byDamping = torque.dot(angular.travel(before.spin, angularAcceleration)) -
                                  (moving.momentum.dot(moving.spin) - before.momentum.dot(before.spin)) * 0.5;
        return {linear.unlessUndamped(byDrag), angular.unlessUndamped(byDamping)};
    }
};

/// See turnGently.
Quaternions turnGently(const Bodies& bodies, const Vectors& momentumInBody, const Numbers& dt) {
    const Vectors& inverse = bodies.inversePrincipal;
    const Vectors p0 = dt * momentumInBody, w0 = p0.times(inverse);
    const Vectors p1 = p0.cross(w0), w1 = p1.times(inverse);
    const Vectors p2 = spread(0.5) * (p1.cross(w0) + p0.cross(w1)), w2 = p2.times(inverse);
    const Vectors w3 = spread(1. / 3) * (p2.cross(w0) + p1.cross(w1) + p0.cross(w2)).times(inverse);
    const Vectors half = spread(0.5) * w0 + spread(0.25) * w1 + spread(1. / 6) * w2 + spread(0.125) * w3 +
                         spread(1. / 24) * w0.cross(w1 + w2);
    const Numbers square = half.dot(half);
    return {(1.0 - square * (1. / 6 - square * (1. / 120))) * half,
            1.0 - square * (0.5 - square * (1. / 24 - square * (1. / 720)))};
}

/// Of unit length but for rounding: see `fly`.
Quaternions product(const Quaternions& a, const Quaternions& b) {
    const Quaternions q = a * b;
    const Numbers scale = 1.5 - 0.5 * (q.vec.dot(q.vec) + q.w * q.w);
    return {scale * q.vec, scale * q.w};
}

/// See `isAtRest`, by squares.
Outcomes areAtRest(const Moving& settled, const Bodies& bodies, const HalfKick& kick, const Numbers& length,
                   const Numbers& gravity) {
    const Numbers perLength = 1.0 / (bodies.mass * length);
    const Numbers speed2 = 2.0 * bodies.kineticEnergy(settled) / bodies.mass;
    const Vectors angular = perLength * kick.torque;
    const Numbers most = restImbalance * gravity, most2 = most * most;
    const Outcomes isSlow = speed2 <= restFroudeNumber * restFroudeNumber * gravity * length,
                   isBalanced = kick.acceleration.dot(kick.acceleration) <= most2,
                   isTrimmed = angular.dot(angular) <= most2;
    return isSlow & isBalanced & isTrimmed;
}

void step(const ArrivalRows& arrivals, const LoadRows& loads, double gravity, double dt,
          CalmStepRows& steps) {
    const Numbers time = spread(dt), half = spread(dt / 2), none{}, one = spread(1.0);
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const Bodies bodies{load(arrivals.mass, lane), load(arrivals.inversePrincipal, lane)};
        const Quaternions orientation = load(arrivals.pose.orientation, lane);
        const Rotations axes(orientation);
        const Vectors torque = load(loads.torque, lane);
        const HalfKick kick{Damped(load(loads.dragRate, lane), half),
                            Damped(load(loads.dampingRate, lane), half), torque,
                            (1.0 / bodies.mass) * load(loads.force, lane), bodies.spin(axes, torque)};

        Moving moving = Moving::from(arrivals.moving, lane);
        Dissipated taken = kick.apply(moving, bodies.mass);
        taken.byDrag += load(arrivals.dissipated.byDrag, lane);
        taken.byDamping += load(arrivals.dissipated.byDamping, lane);
        const Numbers energy = bodies.kineticEnergy(moving) + load(loads.potential, lane);
        const Numbers available = load(arrivals.available, lane) - (taken.byDrag + taken.byDamping);
        moving.putInto(steps.settled, lane);
        taken.putInto(steps.dissipated, lane);
        store(energy, steps.energy, lane);
        store(available, steps.available, lane);
        store(areAtRest(moving, bodies, kick, load(arrivals.length, lane), spread(gravity)) ? one : none,
              steps.isAtRest, lane);

        kick.apply(moving, bodies.mass).putInto(steps.dissipatedNext, lane);
        const Quaternions turned =
            product(orientation, turnGently(bodies, axes.transposed(moving.momentum), time));
        const Vectors position = load(arrivals.pose.position, lane) + time * moving.velocity;
        const Vectors spinThere = bodies.spin(Rotations(turned), moving.momentum);
        moving.putInto(steps.departing, lane);
        store(position, steps.target.position, lane);
        store(turned, steps.target.orientation, lane);
        store(spinThere, steps.spinAtTarget, lane);

        const Numbers turn2 = moving.spin.dot(moving.spin) * time * time;
        const Outcomes isGentle = turn2 < spread(gentleTurn * gentleTurn),
                       isWithinEnergy = energy <= available + load(loads.potentialRounding, lane),
                       isFinite = areFinite(moving.velocity + moving.spin + spinThere);
        const Outcomes isCalm =
            isGentle & kick.linear.isInSeries & kick.angular.isInSeries & isWithinEnergy & isFinite;
        store(isCalm ? one : none, steps.isCalm, lane);
    }
}

}  // namespace

extern const CalmStepKernels calmStepKernels;

const CalmStepKernels calmStepKernels = {step};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
