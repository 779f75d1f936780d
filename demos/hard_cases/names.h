#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace bullet_buoyancy::demo {

inline std::string text(double number) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", number);
    return buffer;
}

/// "1/60 s"
inline std::string stepName(double dt) {
    return "1/" + text(std::round(1 / dt)) + " s";
}

}  // namespace bullet_buoyancy::demo
