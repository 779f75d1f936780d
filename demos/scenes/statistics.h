#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bullet_buoyancy::scenes {

/// Of at least one value; the upper one of the two in the middle.
inline double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Of at least one value; NaN if any is.
inline double largest(const std::vector<double>& values) {
    double result = values.front();
    for (double value : values)
        if (!(value <= result)) result = value;
    return result;
}

}  // namespace bullet_buoyancy::scenes
