#include "rotation_schemes/measure.h"

#include <chrono>
#include <cmath>

#include "scenes/statistics.h"

namespace bullet_buoyancy::demo {

namespace {

using LongTumbler = TumblerOf<long double>;

double energy(const Vec3& principal, const Vec3& momentum) {
    return momentum.dot(momentum.cwiseQuotient(principal)) / 2;
}

/// NaN stays: std::max would drop it.
void raise(double& largest, double value) {
    if (!(value <= largest)) largest = value;
}

}  // namespace

Vec3 SpinCase::principal() const {
    const Vec3 squares = halfExtents.cwiseAbs2() / 3;
    return Vec3::Constant(squares.sum()) - squares;
}

Tumbler SpinCase::start() const {
    Tumbler body;
    body.momentum = principal().cwiseProduct(spin);
    return body;
}

SchemeError measureError(const Scheme& scheme, const SpinCase& spin, double dt, double seconds) {
    constexpr int partsOfAStep = 4;
    const Vec3 principal = spin.principal();
    Tumbler body = spin.start();
    const double energyBefore = energy(principal, body.momentum), lengthBefore = body.momentum.norm();
    LongTumbler truth;
    truth.momentum = body.momentum.cast<long double>();

    SchemeError error;
    for (long i = 0; i < std::lround(seconds / dt); ++i) {
        scheme.step(principal, body, dt);
        for (int part = 0; part < partsOfAStep; ++part)
            turnByTaylorSeries<long double>(principal.cast<long double>(), truth,
                                            static_cast<long double>(dt) / partsOfAStep);
        const Eigen::Quaterniond difference = truth.orientation.cast<double>().conjugate() * body.orientation;
        raise(error.orientation, 2 * std::atan2(difference.vec().norm(), std::abs(difference.w())));
        raise(error.energy, std::abs(energy(principal, body.momentum) / energyBefore - 1));
        raise(error.momentum, std::abs(body.momentum.norm() / lengthBefore - 1));
    }
    return error;
}

double measureTime(const Scheme& scheme, const SpinCase& spin, double dt, int stepsInABlock) {
    const Vec3 principal = spin.principal();
    std::vector<double> blocks(9);
    volatile double keep = 0;  // what is not used need not be computed
    for (double& block : blocks) {
        Tumbler body = spin.start();
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < stepsInABlock; ++i)
            scheme.step(principal, body, dt);
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        keep = keep + body.orientation.w();
        block = time.count() / stepsInABlock;
    }
    return scenes::median(blocks);
}

}  // namespace bullet_buoyancy::demo
