#include "bullet_buoyancy/motion/free_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bullet_buoyancy/core/constants.h"

// Euler's equations without torque are w_i' = a_i w_j w_k, (i, j, k) cyclic, a_i = (I_j - I_k) / I_i. Their
// solutions are a_j a_k w_i^2 = p(t) - e_i, with Weierstrass's function p at a time counted from a complex
// origin, and constants e_i of the sum 0 (Whittaker and Watson, A Course of Modern Analysis, chapter XX). So
// p(t) is the mean of the a_j a_k w_i^2, and the addition theorem of p steps the spin exactly:
//
//   w_i(t +- s) = (P_j P_k w_i +- s a_i P_i w_j w_k) / D,
//   D = s^2 (p(s) - p(t)),   P_i^2 = s^2 (p(s) - e_i) = D + s^2 a_j a_k w_i^2.
//
// The momentum is at rest in the world, so the body's turn from t - s to t + s takes I w(t + s) to I w(t -
// s). Rotations that do have the tangents of half their angle, along their axis,
//
//   g_i = s (1 + l I_i) w_i(t) / P_i,
//
// with any l. That the l of the true turn is the same all along a motion is what makes the discrete
// Moser-Veselov algorithm exact, given suitably changed moments (Hairer and Vilmart, Preprocessed discrete
// Moser-Veselov algorithm for the full dynamics of a rigid body, J. Phys. A 39, 2006). From the rotation with
// l = 0 to the true one it is a turn about the momentum L, by an angle of 2 |L| J; put together, they give
//
//   l = T / s (1 + sum_i s^2 w_i^2 / P_i^2) / (1 - T sum_i s I_i w_i^2 / P_i^2),
//   T = P_1 P_2 P_3 tan(|L| J) / (|L| D),
//   dJ/ds = s^2 sum_i (I_j + I_k - I_i) I_i w_i^2 / P_i^2 / (I_1 I_2 I_3 (1 + sum_i s^2 w_i^2 / P_i^2)),
//
// the last from g' = (w(t + s) + w(t - s) + g x (w(t + s) - w(t - s)) + g g . (w(t + s) + w(t - s))) / 2. In
// these three w may be the spin at any time of the motion. Below, half the step is the unit of time: s is 1.

namespace bullet_buoyancy {

namespace {

/// Up to this angle in half a piece of a step the series and the quadrature reach rounding.
constexpr double largestHalfTurn = pi / 8;
constexpr int mostPieces = 1000;

/// s^2 p(s) = 1 + sum of c_n s^(2n) from n = 2 on, at s up to 1 (Abramowitz and Stegun 18.5).
class WeierstrassSeries {
public:
    explicit WeierstrassSeries(const Vec3& e) : c2(e.squaredNorm() / 10), c3(e.prod() / 7) {}

    double operator()(double z) const {
        return 1 + z * z * (c2 + z * (c3 + z * (c4 + z * (c5 + z * (c6 + z * (c7 + z * (c8 + z * c9)))))));
    }

private:
    double c2, c3;
    double square2 = c2 * c2, square3 = c3 * c3, cube2 = c2 * square2;
    double c4 = square2 * (1. / 3);
    double c5 = c2 * c3 * (3. / 11);
    double c6 = (2 * cube2 + 3 * square3) * (1. / 39);
    double c7 = square2 * c3 * (2. / 33);
    double c8 = c2 * (11 * cube2 + 36 * square3) * (5. / 7293);
    double c9 = c3 * (29 * cube2 + 11 * square3) * (1. / 2717);
};

Vec3 productsOfOthers(const Vec3& v) {
    return {v.y() * v.z(), v.z() * v.x(), v.x() * v.y()};
}

Vec3 ratios(const Vec3& inertia) {
    return Vec3(inertia.y() - inertia.z(), inertia.z() - inertia.x(), inertia.x() - inertia.y())
        .cwiseQuotient(inertia);
}

/// Half a step of a motion. The names are those above.
struct HalfStep {
    Vec3 inertia, a, w;
    Vec3 square = w.cwiseAbs2();
    Vec3 g = square.cwiseProduct(productsOfOthers(a));  // a_j a_k w_i^2
    double c = g.mean();
    WeierstrassSeries series{Vec3::Constant(c) - g};

    HalfStep(const Vec3& principal, const Vec3& angle) : inertia(principal), a(ratios(principal)), w(angle) {}

    double d(double z) const { return series(z) - z * c; }
    Vec3 pSquared(double z) const { return Vec3::Constant(d(z)) + z * g; }
    double slip() const;
    Vec3 halfTangents() const;
};

/// J, by the 13 points of Gauss and Legendre on [-1, 1], of which symmetry and the zero at 0 leave six.
double HalfStep::slip() const {
    struct Point {
        double square, weight;
    };
    constexpr double x1 = 0.23045831595513479, x2 = 0.44849275103644685, x3 = 0.64234933944034022,
                     x4 = 0.80157809073330991, x5 = 0.91759839922297797, x6 = 0.98418305471858815;
    constexpr Point points[] = {{x1 * x1, 0.22628318026289724},  {x2 * x2, 0.2078160475368885},
                                {x3 * x3, 0.17814598076194574},  {x4 * x4, 0.13887351021978724},
                                {x5 * x5, 0.092121499837728448}, {x6 * x6, 0.04048400476531588}};
    const Vec3 numerators = (Vec3::Constant(inertia.sum()) - 2 * inertia)
                                .cwiseProduct(square)
                                .cwiseQuotient(productsOfOthers(inertia));
    double sum = 0;
    for (const Point& point : points) {
        const Vec3 p = pSquared(point.square), others = productsOfOthers(p);
        sum += point.weight * point.square * numerators.dot(others) /
               (p.prod() + point.square * square.dot(others));
    }
    return sum;
}

/// tan(x) / x from x^2, for the angles about L, which are below 0.05 whatever the moments.
double tangentOverAngle(double y) {
    return 1 + y * (1. / 3 + y * (2. / 15 + y * (17. / 315 + y * (62. / 2835))));
}

/// Of the rotation over the whole step that begins at w: its middle is half a step later.
Vec3 HalfStep::halfTangents() const {
    const Vec3 p = pSquared(1), others = productsOfOthers(p);
    const double product = p.prod(), root = std::sqrt(product), inverse = 1 / (product * d(1));
    const Vec3 overP = inverse * others;  // 1 / (P_i^2 D)
    const Vec3 middleOverP =
        root * w.cwiseProduct(overP) + product * inverse * a.cwiseProduct(productsOfOthers(w));

    // l, from w: at the middle it is the same.
    const Vec3 momentum = inertia.cwiseProduct(w);
    const double j = slip(), angleSquare = momentum.squaredNorm() * j * j;
    const double tangentTimesD = root * j * tangentOverAngle(angleSquare);
    const double l = tangentTimesD * (product * inverse + square.dot(overP)) /
                     (1 - tangentTimesD * momentum.dot(w.cwiseProduct(overP)));
    return (Vec3::Ones() + l * inertia).cwiseProduct(middleOverP);
}

Eigen::Quaterniond turnByAPiece(const Vec3& principal, const Vec3& angle) {
    const Vec3 tangents = HalfStep(principal, angle).halfTangents();
    const double scalar = 1 / std::sqrt(1 + tangents.squaredNorm());
    Eigen::Quaterniond turn;
    turn.w() = scalar;
    turn.vec() = scalar * tangents;
    return turn;
}

/// The share of a step that can be taken at once, given the angle by which half of it would turn the body.
double largestPiece(const Vec3& principal, const Vec3& angle) {
    const Vec3 squares = angle.cwiseAbs2(), g = squares.cwiseProduct(productsOfOthers(ratios(principal)));
    const double size = std::sqrt(std::max(squares.sum(), g.cwiseAbs().maxCoeff()));
    return size > largestHalfTurn ? largestHalfTurn / size : 1;
}

}  // namespace

Eigen::Quaterniond turnFreely(const Vec3& principal, const Vec3& momentumInBody, double dt) {
    const Vec3 momentum = dt / 2 * momentumInBody;
    const Vec3 angle = momentum.cwiseQuotient(principal);
    double done = largestPiece(principal, angle);
    Eigen::Quaterniond turn = turnByAPiece(principal, done * angle);
    for (int pieces = 1; done < 1 && pieces < mostPieces; ++pieces) {
        const Vec3 angleNow = (turn.conjugate() * momentum).cwiseQuotient(principal);
        const double piece = std::min(largestPiece(principal, angleNow), 1 - done);
        turn = (turn * turnByAPiece(principal, piece * angleNow)).normalized();
        done += piece;
    }
    return turn;
}

/// Four orders of Magnus's series. The spin is w0 + w1 t + w2 t^2 + w3 t^3 by Euler's equations, P' = P x w;
/// the step is the unit of time (Blanes, Casas, Oteo and Ros, The Magnus expansion and some of its
/// applications, Phys. Rep. 470, 2009, 2.3).
Eigen::Quaterniond turnGently(const Vec3& principal, const Vec3& momentumInBody, double dt) {
    const Vec3 inverse = principal.cwiseInverse();
    const Vec3 p0 = dt * momentumInBody, w0 = p0.cwiseProduct(inverse);
    const Vec3 p1 = p0.cross(w0), w1 = p1.cwiseProduct(inverse);
    const Vec3 p2 = (p1.cross(w0) + p0.cross(w1)) * 0.5, w2 = p2.cwiseProduct(inverse);
    const Vec3 w3 = (p2.cross(w0) + p1.cross(w1) + p0.cross(w2)).cwiseProduct(inverse) * (1. / 3);
    const Vec3 half = w0 * 0.5 + w1 * 0.25 + w2 * (1. / 6) + w3 * 0.125 + w0.cross(w1 + w2) * (1. / 24);
    const double square = half.squaredNorm();  // the series of sine and cosine reach rounding
    Eigen::Quaterniond turn;
    turn.w() = 1 - square * (0.5 - square * (1. / 24 - square * (1. / 720)));
    turn.vec() = half * (1 - square * (1. / 6 - square * (1. / 120)));
    return turn;
}

Vec3 rotationVector(const Eigen::Quaterniond& rotation) {
    const double square = rotation.vec().squaredNorm(), cosine = rotation.w();
    constexpr double seriesEnds = 1e-3;  // beyond, its terms that are left out pass rounding
    if (square < seriesEnds) {           // of the arc sine
        const double halfAngleOverSine =
            1 + square * (1. / 6 + square * (3. / 40 + square * (5. / 112 + square * (35. / 1152))));
        return std::copysign(2 * halfAngleOverSine, cosine) * rotation.vec();
    }
    const double sine = std::sqrt(square);
    return 2 * std::atan2(std::copysign(sine, cosine), std::abs(cosine)) / sine * rotation.vec();
}

}  // namespace bullet_buoyancy
