#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy::fuzz {

/// How numbers are written in a fuzzer's bytes: a byte up to `lastOfGrid` is a place on a grid, on which
/// points often coincide and lie in line, one above says what follows.
enum NumberKind : std::uint8_t {
    lastOfGrid = 239,
    aDouble,  ///< of 8 bytes
    aFloat,   ///< of 4
    aNan,
    infinity,
    huge,
    tiny,
    nearly,  ///< a place on the grid but for rounding in single precision
};

/// The places of the grid are 1/32 apart about zero, at this byte.
inline constexpr int middleOfGrid = 120;

/// Takes a fuzzer's bytes one after another for what is asked for; zero bytes after the last.
class Input {
public:
    Input(const std::uint8_t* bytes, std::size_t size) : m_bytes(bytes), m_left(size) {}

    bool isAtEnd() const { return m_left == 0; }

    std::uint8_t byte() {
        if (m_left == 0) return 0;
        --m_left;
        return *m_bytes++;
    }

    bool coin() { return byte() % 2 == 1; }

    /// 0 to count - 1, of one byte.
    int index(int count) { return byte() % count; }

    /// The bits of any plain type.
    template <typename T>
    T bits() {
        T value{};
        const std::size_t count = m_left < sizeof value ? m_left : sizeof value;
        if (count > 0) std::memcpy(&value, m_bytes, count);
        m_bytes += count;
        m_left -= count;
        return value;
    }

    /// Any number at all, most often one within 4 of zero.
    double number() {
        const int kind = byte();
        switch (kind) {
            case aDouble:
                return bits<double>();
            case aFloat:
                return double(bits<float>());
            case aNan:
                return std::numeric_limits<double>::quiet_NaN();
            case infinity:
                return std::numeric_limits<double>::infinity();
            case huge:
                return 1e30;
            case tiny:
                return 1e-30;
            case nearly:
                return onGrid(byte()) * (1 + double(std::numeric_limits<float>::epsilon()));
            default:
                return onGrid(kind);
        }
    }

    /// -1 to 1, evenly.
    double unit() { return double(bits<std::uint16_t>()) / 32767.5 - 1; }

    Vec3 vector() {
        const double x = number(), y = number();
        return {x, y, number()};
    }

    /// Each coordinate -1 to 1.
    Vec3 inCube() {
        const double x = unit(), y = unit();
        return {x, y, unit()};
    }

private:
    static double onGrid(int place) { return (place - middleOfGrid) / 32.0; }

    const std::uint8_t* m_bytes;
    std::size_t m_left;
};

}  // namespace bullet_buoyancy::fuzz
