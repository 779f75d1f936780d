#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

/// Gauss-Legendre quadrature on [-1, 1]: exact for polynomials up to degree 2 n - 1.
template <std::size_t n>
struct GaussLegendre {
    std::array<double, n> nodes;
    std::array<double, n> weights;

    /// Roots of the Legendre polynomial P_n by Newton's method from Tricomi's estimate; weights
    /// 2 / ((1 - x^2) P_n'(x)^2) (Abramowitz and Stegun 25.4.29).
    GaussLegendre() {
        for (std::size_t i = 0; i < n; ++i) {
            double x = std::cos(pi * (double(i) + 0.75) / (double(n) + 0.5));
            double derivative = 0;
            for (int iteration = 0; iteration < 8; ++iteration) {
                double previous = 1, value = x;
                for (std::size_t k = 2; k <= n; ++k) {
                    const double next =
                        ((2 * double(k) - 1) * x * value - (double(k) - 1) * previous) / double(k);
                    previous = value;
                    value = next;
                }
                derivative = double(n) * (x * value - previous) / (x * x - 1);
                x -= value / derivative;
            }
            nodes[i] = x;
            weights[i] = 2 / ((1 - x * x) * derivative * derivative);
        }
    }
};

/// Nodes and weights on [-pi/2, pi/2] as functions of sin and cos: integrates f(x) over [begin, end] with
/// x = middle + half * sin(theta), which turns square-root singularities at both ends into smooth functions.
template <std::size_t n>
struct SineQuadrature {
    std::array<double, n> nodes;    ///< sin(theta): position in [-1, 1]
    std::array<double, n> weights;  ///< d sin(theta)

    SineQuadrature() {
        const GaussLegendre<n> rule;
        for (std::size_t i = 0; i < n; ++i) {
            const double theta = rule.nodes[i] * pi / 2;
            nodes[i] = std::sin(theta);
            weights[i] = rule.weights[i] * pi / 2 * std::cos(theta);
        }
    }

    /// Calls `visit(x, weight)` at each node of [begin, end].
    template <typename Visit>
    void over(double begin, double end, const Visit& visit) const {
        const double middle = (begin + end) / 2, half = (end - begin) / 2;
        for (std::size_t i = 0; i < n; ++i)
            visit(middle + half * nodes[i], half * weights[i]);
    }
};

}  // namespace bullet_buoyancy
