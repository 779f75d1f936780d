#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// A sum of floating-point numbers without rounding, kept as parts that do not overlap, smallest first
/// (grow-expansion: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates", 1997).
class ExactSum {
public:
    void add(double term) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_count; ++i) {
            const double sum = term + m_parts[i];
            const double share = sum - term;
            const double error = (term - (sum - share)) + (m_parts[i] - share);
            if (error != 0) m_parts[kept++] = error;
            term = sum;
        }
        if (term != 0) m_parts[kept++] = term;
        m_count = kept;
    }

    void addProduct(double a, double b, double c) {
        const double ab = a * b, error = std::fma(a, b, -ab);
        for (double factor : {ab, error}) {
            const double product = factor * c;
            add(product);
            add(std::fma(factor, c, -product));
        }
    }

    /// Has the sign of the exact sum: the last part outweighs all others.
    double rounded() const {
        double sum = 0;
        for (std::size_t i = 0; i < m_count; ++i)
            sum += m_parts[i];
        return sum;
    }

private:
    std::array<double, 32> m_parts;  // a determinant adds 24 terms
    std::size_t m_count = 0;
};

/// The determinant of the columns a, b, c, of the right sign, and 0 exactly where it is 0. The coordinates
/// are whole numbers of up to 2^53.
inline double exactDeterminant(const Vec3& a, const Vec3& b, const Vec3& c) {
    double determinant = 0, magnitude = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        determinant += a[i] * (b[j] * c[k] - b[k] * c[j]);
        magnitude += std::abs(a[i]) * (std::abs(b[j] * c[k]) + std::abs(b[k] * c[j]));
    }
    if (std::abs(determinant) > 8 * std::numeric_limits<double>::epsilon() * magnitude) return determinant;

    ExactSum sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum.addProduct(a[i], b[j], c[k]);
        sum.addProduct(-a[i], b[k], c[j]);
    }
    return sum.rounded();
}

}  // namespace bullet_buoyancy
