#pragma once

#include <array>
#include <cmath>

namespace bullet_buoyancy::test {

struct JacobiElliptic {
    double sn, cn, dn;
};

/// Jacobi's elliptic functions of a real argument, with the parameter m = k^2 in [0, 1): by the
/// arithmetic-geometric mean (Abramowitz and Stegun 16.4).
inline JacobiElliptic jacobiElliptic(double argument, double m) {
    constexpr std::size_t most = 10;  // the mean converges quadratically: five or six are enough
    std::array<double, most + 1> mean{1}, difference{std::sqrt(m)};
    double geometric = std::sqrt(1 - m), scale = 1;
    std::size_t n = 0;
    while (n < most && std::abs(difference[n]) > 1e-16) {
        mean[n + 1] = (mean[n] + geometric) / 2;
        difference[n + 1] = (mean[n] - geometric) / 2;
        geometric = std::sqrt(mean[n] * geometric);
        scale *= 2;
        ++n;
    }
    double amplitude = scale * mean[n] * argument;
    for (; n > 0; --n)
        amplitude = (amplitude + std::asin(difference[n] / mean[n] * std::sin(amplitude))) / 2;
    const double sn = std::sin(amplitude);
    return {sn, std::cos(amplitude), std::sqrt(1 - m * sn * sn)};
}

}  // namespace bullet_buoyancy::test
