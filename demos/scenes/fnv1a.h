#pragma once

#include <cstdint>
#include <cstring>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy::scenes {

/// A hash of numbers by their bits, to tell whether two runs have the same results: FNV-1a of 64 bits.
class Fnv1a {
public:
    void add(double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        for (int byte = 0; byte < 8; ++byte) {
            m_hash ^= (bits >> (8 * byte)) & 0xff;
            m_hash *= 0x100000001b3;
        }
    }

    void add(const Vec3& vector) {
        for (double value : vector)
            add(value);
    }

    std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325;
};

}  // namespace bullet_buoyancy::scenes
