#pragma once

#include <algorithm>
#include <vector>

#include "bullet_buoyancy/bullet/action_state.h"
#include "fuzz/input.h"

namespace bullet_buoyancy::fuzz {

using StateBytes = std::vector<std::byte>;

/// Whole words of a state: the last one is the check sum.
inline std::size_t words(const StateBytes& bytes) {
    return bytes.size() / 8;
}

inline std::uint64_t word(const StateBytes& bytes, std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i)
        value |= std::uint64_t(bytes[8 * at + i]) << (8 * i);
    return value;
}

inline void setWord(StateBytes& bytes, std::size_t at, std::uint64_t value) {
    for (std::size_t i = 0; i < 8; ++i)
        bytes[8 * at + i] = std::byte(value >> (8 * i));
}

/// The library's, of all words but the last.
inline std::uint64_t checkSum(const StateBytes& bytes) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i + 1 < words(bytes); ++i) {
        sum = (sum ^ word(bytes, i)) * 0x9e3779b97f4a7c15u;
        sum ^= sum >> 32;
    }
    return sum;
}

enum StateKind : std::uint8_t { rawState, changedState, stateKinds };
enum StateEdit : std::uint8_t { setNumber, setBits, setSmall, exchange, cutShort, stateEdits };

inline void edit(StateBytes& bytes, Input& input) {
    const int edit = input.index(stateEdits);
    const std::size_t at = input.bits<std::uint16_t>() % std::max<std::size_t>(words(bytes), 1);
    if (edit == cutShort) bytes.resize(std::min(bytes.size(), std::size_t(input.bits<std::uint16_t>())));
    if (at >= words(bytes)) return;
    if (edit == setBits) setWord(bytes, at, input.bits<std::uint64_t>());
    if (edit == setSmall) setWord(bytes, at, input.byte());
    if (edit == exchange) setWord(bytes, at, word(bytes, input.bits<std::uint16_t>() % words(bytes)));
    if (edit == setNumber) {
        const double number = input.number();
        std::uint64_t bits;
        std::memcpy(&bits, &number, sizeof bits);
        setWord(bytes, at, bits);
    }
}

/// Any bytes, or some words of `home` changed, most often so that the check sum does not tell.
inline ActionState readState(Input& input, ActionState home) {
    if (input.index(stateKinds) == rawState) {
        home.bytes.clear();
        while (!input.isAtEnd())
            home.bytes.push_back(std::byte(input.byte()));
        return home;
    }
    const bool signs = input.index(8) != 0;
    for (int i = 0; i < 16 && !input.isAtEnd(); ++i)
        edit(home.bytes, input);
    if (signs && words(home.bytes) > 0) setWord(home.bytes, words(home.bytes) - 1, checkSum(home.bytes));
    return home;
}

}  // namespace bullet_buoyancy::fuzz
