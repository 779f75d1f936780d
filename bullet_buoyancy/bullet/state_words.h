#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

#include "bullet_buoyancy/bullet/state_members.h"

namespace bullet_buoyancy {

/// A state as a row of words of 64 bits, the lowest byte first on any machine: one a number, whatever its
/// type.
constexpr std::size_t wordSize = 8;

template <class T>
constexpr bool isNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Of the last enumerator, for those enumerations that are saved.
constexpr std::uint64_t lastOf(BodyState) {
    return std::uint64_t(BodyState::badStep);
}
constexpr std::uint64_t lastOf(StepScheme) {
    return std::uint64_t(StepScheme::published);
}

/// How many words a value takes.
template <class T>
constexpr std::size_t wordsOf();

template <class... Members>
constexpr std::size_t wordsOfAll(const std::tuple<Members&...>*) {
    return (wordsOf<std::remove_const_t<Members>>() + ...);
}

template <class T>
constexpr std::size_t wordsOf() {
    if constexpr (isNumber<T>)
        return 1;
    else if constexpr (std::is_same_v<T, btVector3> || std::is_same_v<T, Vec3>)
        return 3;
    else if constexpr (std::is_same_v<T, Eigen::Quaterniond>)
        return 4;
    else if constexpr (std::is_same_v<T, btTransform>)
        return 12;
    else
        return wordsOfAll(static_cast<decltype(StateMembers::of(std::declval<T&>()))*>(nullptr));
}

template <class Value, class Visitor>
void visitNumbers(Value& value, Visitor& visitor);

template <class Visitor, class... Members>
void visitAll(Visitor& visitor, std::tuple<Members&...> members) {
    std::apply([&](Members&... each) { (visitNumbers(each, visitor), ...); }, members);
}

/// Calls the visitor for each number in a value, always in the same order.
template <class Value, class Visitor>
void visitNumbers(Value& value, Visitor& visitor) {
    using Plain = std::remove_const_t<Value>;
    if constexpr (isNumber<Plain>) {
        visitor(value);
    } else if constexpr (std::is_same_v<Plain, btVector3>) {
        for (int i = 0; i < 3; ++i)
            visitor(value[i]);
    } else if constexpr (std::is_same_v<Plain, btTransform>) {
        for (int row = 0; row < 3; ++row)
            visitNumbers(value.getBasis()[row], visitor);
        visitNumbers(value.getOrigin(), visitor);
    } else if constexpr (std::is_same_v<Plain, Vec3>) {
        for (int i = 0; i < 3; ++i)
            visitor(value[i]);
    } else if constexpr (std::is_same_v<Plain, Eigen::Quaterniond>) {
        for (int i = 0; i < 4; ++i)
            visitor(value.coeffs()[i]);
    } else {
        visitAll(visitor, StateMembers::of(value));
    }
}

class WordWriter {
public:
    /// `to`: enough room for all that will be written.
    explicit WordWriter(std::byte* to) : m_to(to) {}

    template <class Number>
    void operator()(const Number& number) {
        std::uint64_t word;
        if constexpr (std::is_floating_point_v<Number>) {
            const auto wide = double(number);
            std::memcpy(&word, &wide, wordSize);
        } else {
            word = std::uint64_t(number);
        }
        for (std::size_t i = 0; i < wordSize; ++i)
            m_to[i] = std::byte(word >> (8 * i));
        m_to += wordSize;
    }

private:
    std::byte* m_to;
};

class WordReader {
public:
    /// `from`: as much as will be read.
    explicit WordReader(const std::byte* from) : m_from(from) {}

    /// A number that its type cannot have is read as zero.
    template <class Number>
    void operator()(Number& number) {
        const std::uint64_t word = next();
        if constexpr (std::is_floating_point_v<Number>) {
            double wide;
            std::memcpy(&wide, &word, wordSize);
            number = Number(wide);
        } else {
            const bool fits = isIn<Number>(word);
            m_isSound = m_isSound && fits;
            number = fits ? Number(word) : Number();
        }
    }

    /// All numbers that were read are such as their types can have.
    bool isSound() const { return m_isSound; }

private:
    std::uint64_t next() {
        std::uint64_t word = 0;
        for (std::size_t i = 0; i < wordSize; ++i)
            word |= std::uint64_t(m_from[i]) << (8 * i);
        m_from += wordSize;
        return word;
    }

    template <class Number>
    static bool isIn(std::uint64_t word) {
        if constexpr (std::is_same_v<Number, bool>)
            return word <= 1;
        else if constexpr (std::is_enum_v<Number>)
            return word <= lastOf(Number());
        else
            return std::uint64_t(Number(word)) == word;
    }

    const std::byte* m_from;
    bool m_isSound = true;
};

}  // namespace bullet_buoyancy
