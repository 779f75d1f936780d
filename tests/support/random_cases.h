#pragma once

#include <random>

#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy::test {

/// Random numbers that are the same on every machine: the engine is specified by the standard, the mapping is
/// ours.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * double(m_engine() >> 11) * 0x1p-53;
    }

    /// 0 to count - 1; the last few of 2^64 numbers fall to the first few places, which no test can notice.
    std::size_t index(std::size_t count) { return std::size_t(m_engine() % count); }

    bool coin() { return index(2) == 0; }

    Vec3 inCube(double halfSize);
    Vec3 direction();
    Eigen::Quaterniond orientation();

private:
    std::mt19937_64 m_engine;
};

}  // namespace bullet_buoyancy::test
