#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy::scenes {

/// Random numbers that are the same on every machine: the standard specifies the engine, the mapping is ours.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : m_engine(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * double(m_engine() >> 11) * 0x1p-53;
    }

    /// Of which each factor of ten is as likely as another; `low` above 0.
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

    /// 0 to count - 1
    int index(int count) { return int(m_engine() % std::uint64_t(count)); }

    Vec3 inCube(double halfSize) {
        const double x = uniform(-halfSize, halfSize), y = uniform(-halfSize, halfSize);
        return {x, y, uniform(-halfSize, halfSize)};
    }

    /// Any one as likely as another.
    Eigen::Quaterniond orientation() {
        while (true) {
            const Vec3 vector = inCube(1);
            const Eigen::Quaterniond q(uniform(-1, 1), vector.x(), vector.y(), vector.z());
            if (const double length = q.norm(); length > 0.1 && length < 1) return q.normalized();
        }
    }

private:
    std::mt19937_64 m_engine;
};

}  // namespace bullet_buoyancy::scenes
