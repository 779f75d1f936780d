#include "bullet_buoyancy/motion/free_rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/core/constants.h"
#include "support/jacobi_elliptic.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

using Eigen::Quaterniond;

/// What turnFreely may differ from the truth by in a step of up to pi/4: rounding of 1e-16, of which thin
/// rods and sheets make some 1e-14.
constexpr double stepTolerance = 2e-14;
constexpr double fastest = pi / 4;

/// Of the rotation from one to the other, rad.
double angleBetween(const Quaterniond& one, const Quaterniond& other) {
    return rotationVector(one.conjugate() * other).norm();
}

double energy(const Vec3& principal, const Vec3& momentum) {
    return momentum.dot(momentum.cwiseQuotient(principal)) / 2;
}

/// Of a body of positive density: x^2, y^2 and z^2 integrated over it are the summands, from sheets and rods
/// (one or two of them nearly 0) to balls.
Vec3 randomMoments(Random& random) {
    Vec3 summands;
    for (double& summand : summands)
        summand = std::exp(random.uniform(-10, 0));
    return Vec3::Constant(summands.sum()) - summands;
}

/// A spin by `angle` in a unit of time; every third nearly about the middle axis, where motions are slowest
/// to turn and quickest to part.
Vec3 randomSpin(Random& random, double angle, const Vec3& moments) {
    if (random.index(3) > 0) return angle * random.direction();
    Vec3 spin = random.inCube(1e-3);
    for (int i = 0; i < 3; ++i)
        if (moments[i] != moments.minCoeff() && moments[i] != moments.maxCoeff()) spin[i] = 1;
    return angle * spin.normalized();
}

/// A body, its momentum in its own axes, and where it has turned.
struct Body {
    Vec3 principal, momentum;
    Quaterniond orientation = Quaterniond::Identity();

    Vec3 spin() const { return momentum.cwiseQuotient(principal); }

    void turn(double dt) {
        const Quaterniond rotation = turnFreely(principal, momentum, dt);
        momentum = rotation.conjugate() * momentum;
        orientation = (orientation * rotation).normalized();
    }
};

/// What rounding of the momentum makes of the angle by which a body turns in a unit of time: much, for a thin
/// rod about its length.
double roundingOfTurn(const Body& body) {
    return 2e-16 * body.momentum.norm() / body.principal.minCoeff();
}

Body spinning(const Vec3& principal, const Vec3& spin) {
    return {principal, principal.cwiseProduct(spin)};
}

/// An independent method: Euler's equations and q' = q (0, w) / 2 by the classical method of Runge and Kutta,
/// in the longest floating-point numbers that there are.
class RungeKutta {
    using Real = long double;

public:
    explicit RungeKutta(const Body& body)
        : m_principal(body.principal.cast<Real>()),
          m_state{body.momentum.cast<Real>(), body.orientation.coeffs().cast<Real>()} {}

    void advance(Real time, int steps) {
        const Real h = time / Real(steps);
        for (int i = 0; i < steps; ++i) {
            const State k1 = rate(m_state), k2 = rate(sum(m_state, h / 2, k1)),
                        k3 = rate(sum(m_state, h / 2, k2)), k4 = rate(sum(m_state, h, k3));
            m_state = sum(sum(sum(sum(m_state, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
        }
    }

    Quaterniond orientation() const {
        return Quaterniond(Eigen::Vector4d(m_state.orientation.normalized().cast<double>()));
    }

private:
    struct State {
        Eigen::Matrix<Real, 3, 1> momentum;
        Eigen::Matrix<Real, 4, 1> orientation;
    };

    static State sum(const State& state, Real h, const State& rate) {
        return {state.momentum + h * rate.momentum, state.orientation + h * rate.orientation};
    }

    State rate(const State& state) const {
        const Eigen::Matrix<Real, 3, 1> spin = state.momentum.cwiseQuotient(m_principal);
        const Eigen::Quaternion<Real> q(state.orientation), w(0, spin.x(), spin.y(), spin.z());
        return {state.momentum.cross(spin), (q * w).coeffs() / 2};
    }

    Eigen::Matrix<Real, 3, 1> m_principal;
    State m_state;
};

/// Landau and Lifshitz, Mechanics, paragraph 37: the motion of a body with the moments I1 < I2 < I3 that has
/// the energy and the momentum of `spin`, at a time counted from when the spin about the middle axis is 0.
Vec3 spinByEllipticFunctions(const Vec3& moments, const Vec3& spin, double time) {
    const double twiceEnergy = moments.dot(spin.cwiseAbs2());
    const double square = moments.cwiseAbs2().dot(spin.cwiseAbs2());
    const bool aboutThird = square >= twiceEnergy * moments[1];
    const int first = aboutThird ? 0 : 2, third = 2 - first;
    const double i1 = moments[first], i2 = moments[1], i3 = moments[third];
    const double surplus = twiceEnergy * i3 - square, rest = square - twiceEnergy * i1;
    const double rate = std::sqrt((i3 - i2) * rest / (i1 * i2 * i3));
    const JacobiElliptic f = jacobiElliptic(rate * time, (i2 - i1) * surplus / ((i3 - i2) * rest));
    Vec3 result;
    result[first] = std::sqrt(surplus / (i1 * (i3 - i1))) * f.cn;
    result[1] = std::sqrt(surplus / (i2 * (i3 - i2))) * f.sn;
    result[third] = std::sqrt(rest / (i3 * (i3 - i1))) * f.dn;
    return result;
}

TEST(FreeRotation, SpinFollowsJacobisEllipticFunctions) {
    Random random(1);
    int aboutTheFirst = 0;
    for (int i = 0; i < 1000; ++i) {
        Vec3 moments = randomMoments(random);
        std::sort(moments.begin(), moments.end());
        const Vec3 invariants = randomSpin(random, 1, moments);
        const double start = random.uniform(-5, 5), dt = random.uniform(0, fastest);
        Body body = spinning(moments, spinByEllipticFunctions(moments, invariants, start));
        body.turn(dt);
        // The closed form divides by differences of the moments, the nearest of which are 1e-5 apart or so.
        const double apart = std::min(moments[1] - moments[0], moments[2] - moments[1]) / moments[2];
        EXPECT_LT((body.spin() - spinByEllipticFunctions(moments, invariants, start + dt)).norm(),
                  stepTolerance + roundingOfTurn(body) + 1e-14 / apart);
        aboutTheFirst += energy(moments, body.momentum) * 2 * moments[1] > body.momentum.squaredNorm();
    }
    EXPECT_GT(aboutTheFirst, 200);
    EXPECT_LT(aboutTheFirst, 800);
}

/// omega = (cn, sn, dn)(t | 1/3) for the moments 1, 2, 3 and the spin (1, 0, 1); the digits are published
/// ones of these functions and of the attitude that they give, rounded to ten.
TEST(FreeRotation, OfTheMomentsOneTwoThreeHasItsPublishedValues) {
    constexpr double digits = 1e-10;
    const int steps = 10;
    Body body = spinning({1, 2, 3}, {1, 0, 1});
    for (int i = 0; i < steps; ++i)
        body.turn(1.0 / steps);
    EXPECT_LT((body.spin() - Vec3(0.5778024718, 0.8161766375, 0.8820158155)).norm(), digits);
    EXPECT_LT(
        angleBetween(body.orientation, Quaterniond(0.7790396026, 0.3582092660, 0.1958299707, 0.4758508610)),
        2 * digits);
    for (int i = steps; i < 10 * steps; ++i)
        body.turn(1.0 / steps);
    EXPECT_LT((body.spin() - Vec3(-0.9210699984, 0.3893970441, 0.9744006606)).norm(), digits);
}

/// With two moments alike the axis of the third goes round the momentum at |L| / I1, and the body round it.
TEST(FreeRotation, OfASymmetricTopIsTwoSteadyTurns) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        Vec3 principal = Vec3::Ones();
        const long axis = long(random.index(3));
        principal[axis] = random.uniform(0.001, 2);
        const double dt = random.uniform(-fastest, fastest);
        const Vec3 spin = random.direction(), momentum = principal.cwiseProduct(spin);
        const Quaterniond expected = Eigen::AngleAxisd(momentum.norm() * dt, momentum.normalized()) *
                                     Eigen::AngleAxisd((spin - momentum)[axis] * dt, Vec3::Unit(axis));
        EXPECT_LT(angleBetween(expected, turnFreely(principal, momentum, dt)), stepTolerance);
    }
}

TEST(FreeRotation, AboutAPrincipalAxisIsSteady) {
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 principal(1, 2, 2.5);
        const Quaterniond turn = turnFreely(principal, 0.7 * principal[axis] * Vec3::Unit(axis), 1);
        EXPECT_LT((rotationVector(turn) - 0.7 * Vec3::Unit(axis)).norm(), stepTolerance);
    }
}

TEST(FreeRotation, AgreesWithAnIndependentMethod) {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3 moments = randomMoments(random);
        const double angle = fastest * std::pow(10, random.uniform(-3, 0));
        const Body body = spinning(moments, randomSpin(random, angle, moments));
        RungeKutta truth(body);
        truth.advance(1, 1000);  // whose error is some (pi / 4 / 1000)^4 / 120, 3e-15
        EXPECT_LT(angleBetween(truth.orientation(), turnFreely(moments, body.momentum, 1)), stepTolerance)
            << moments.transpose() << ", " << body.spin().transpose();
    }
}

/// Bullet's users can set any moments: ones that break the triangle inequality make spins that grow in a
/// step.
TEST(FreeRotation, AgreesForMomentsThatNoBodyHas) {
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        Vec3 moments = Vec3::Ones();
        for (int axis = 1; axis < 3; ++axis)
            moments[axis] = std::exp(random.uniform(-3, 3));
        const double angle = random.uniform(0, fastest);
        const Body body = spinning(moments, angle * random.direction());
        RungeKutta truth(body);
        truth.advance(1, 20000);  // some spins grow to 20 times the first
        EXPECT_LT(angleBetween(truth.orientation(), turnFreely(moments, body.momentum, 1)), 1e-13)
            << moments.transpose() << ", " << body.spin().transpose();
    }
}

TEST(FreeRotation, ByManyRadiansIsStillExact) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const Vec3 moments = randomMoments(random);
        const Body body = spinning(moments, 20 * random.direction());
        Body inSmallSteps = body;
        for (int step = 0; step < 100; ++step)
            inSmallSteps.turn(0.01);
        // What rounding puts between two motions grows at most by exp of the angle, and on average not at
        // all.
        EXPECT_LT(angleBetween(inSmallSteps.orientation, turnFreely(moments, body.momentum, 1)), 1e-10);
    }
}

TEST(FreeRotation, InTwoHalvesIsTheWhole) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 moments = randomMoments(random);
        Body body = spinning(moments, randomSpin(random, random.uniform(0, fastest), moments));
        const Quaterniond whole = turnFreely(moments, body.momentum, 1);
        const double first = random.uniform(0, 1);
        body.turn(first);
        body.turn(1 - first);
        EXPECT_LT(angleBetween(body.orientation, whole), 2 * stepTolerance + roundingOfTurn(body));
    }
}

/// Of a series, the terms that are left out: of the fifth order in the turn.
TEST(GentleRotation, IsTheFreeOneToTheFifthOrder) {
    Random random(11);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vec3 moments = randomMoments(random);
        const double angle = std::pow(10, random.uniform(-6, -1.7));
        const Vec3 spin = angle * random.direction(), momentum = moments.cwiseProduct(spin);
        const double error = angleBetween(turnGently(moments, momentum, 1), turnFreely(moments, momentum, 1));
        worst = std::max(worst, (error - 1e-15) / std::pow(angle, 5));
    }
    EXPECT_LT(worst, 0.1);   // the next coefficients of the series are 1/20, 1/60 and less
    EXPECT_GT(worst, 1e-4);  // it is a series
}

TEST(FreeRotation, RunsBackward) {
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 moments = randomMoments(random);
        Body body = spinning(moments, randomSpin(random, random.uniform(0, fastest), moments));
        const Vec3 start = body.momentum;
        body.turn(1);
        const Quaterniond back = turnFreely(moments, body.momentum, -1);
        const Quaterniond reversed = turnFreely(moments, -body.momentum, 1);
        EXPECT_LT((back * reversed.conjugate()).vec().norm(), 1e-15);
        body.turn(-1);
        const double tolerance = 2 * stepTolerance + roundingOfTurn(body);
        EXPECT_LT(rotationVector(body.orientation).norm(), tolerance);
        EXPECT_LT((body.momentum - start).norm(), tolerance * start.norm());
    }
}

/// Not a matter of the series' accuracy: the map keeps them in closed form.
TEST(FreeRotation, KeepsEnergyAndMomentumToRounding) {
    Random random(8);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 moments = randomMoments(random);
        Body body = spinning(moments, randomSpin(random, random.uniform(0, fastest), moments));
        const double before = energy(moments, body.momentum), length = body.momentum.norm();
        body.turn(1);
        // A momentum that is rounded has, for a thin rod, an energy that is wrong by I3 / I1 as much.
        const double sensitivity = length * length / moments.minCoeff() / before;
        EXPECT_NEAR(energy(moments, body.momentum) / before, 1, 1e-15 * (1 + sensitivity));
        EXPECT_NEAR(body.momentum.norm() / length, 1, 1e-15);
    }
}

TEST(FreeRotation, DoesNotDependOnTheUnits) {
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        const Vec3 moments = randomMoments(random);
        const Vec3 momentum = moments.cwiseProduct(random.inCube(0.4));
        const Quaterniond turn = turnFreely(moments, momentum, 1);
        for (double unit : {0x1p-100, 0x1p-20, 0x1p100}) {  // powers of two, which round nothing
            EXPECT_EQ(turnFreely(unit * moments, unit * momentum, 1).coeffs(), turn.coeffs());
            EXPECT_EQ(turnFreely(moments, momentum / unit, unit).coeffs(), turn.coeffs());
        }
    }
}

/// The axes may be named in any order, if they stay right-handed.
TEST(FreeRotation, TreatsTheAxesAlike) {
    Random random(10);
    for (int i = 0; i < 100; ++i) {
        const Vec3 moments = randomMoments(random), momentum = moments.cwiseProduct(random.inCube(0.4));
        const auto renamed = [](const Vec3& v) { return Vec3(v.y(), v.z(), v.x()); };
        const Vec3 turn = rotationVector(turnFreely(moments, momentum, 1));
        EXPECT_LT((rotationVector(turnFreely(renamed(moments), renamed(momentum), 1)) - renamed(turn)).norm(),
                  stepTolerance);
    }
}

TEST(FreeRotation, WithoutMomentumOrTimeIsNone) {
    EXPECT_EQ(turnFreely({1, 2, 3}, Vec3::Zero(), 1).coeffs(), Quaterniond::Identity().coeffs());
    EXPECT_EQ(turnFreely({1, 2, 3}, {1, 2, 3}, 0).coeffs(), Quaterniond::Identity().coeffs());
}

TEST(FreeRotation, IsOfUnitLength) {
    Random random(11);
    for (double angle : {1e-9, 0.1, 0.7, 3.0}) {
        const Vec3 moments = randomMoments(random);
        const Vec3 momentum = angle * moments.cwiseProduct(random.direction());
        EXPECT_NEAR(turnFreely(moments, momentum, 1).norm(), 1, 1e-15);
    }
}

TEST(FreeRotation, BeyondAnyReasonStillKeepsTheEnergy) {
    Body body = spinning({1e-9, 1, 2}, {1, 1, 1});
    const double before = energy(body.principal, body.momentum);
    body.turn(1000);
    EXPECT_NEAR(body.orientation.norm(), 1, 1e-15);
    // The momentum, rounded 1000 times, has the energy of its part along the first axis to 1e-16 / 1e-9 of
    // it.
    EXPECT_NEAR(energy(body.principal, body.momentum) / before, 1, 1e-3);
}

/// There is nothing right to return, but it has to return.
TEST(FreeRotation, ReturnsWhateverItIsGiven) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    for (double wrong : {nan, infinity, 0.0, 1e300, 1e-300}) {
        turnFreely({1, 2, wrong}, {1, 2, 3}, 1);
        turnFreely({1, 2, 3}, {1, 2, wrong}, 1);
        turnFreely({1, 2, 3}, {1, 2, 3}, wrong);
    }
}

/// Moments of a homogeneous box, of the mass 1.
Vec3 momentsOfBox(const Vec3& halfExtents) {
    const Vec3 squares = halfExtents.cwiseAbs2() / 3;
    return Vec3::Constant(squares.sum()) - squares;
}

/// Ten seconds at sixty steps a second, against Runge-Kutta with steps 200 times as small, whose error is
/// below 1e-13, times what the motion itself makes of small differences, some 1000.
void tumble(const Vec3& halfExtents, const Vec3& spin) {
    Body body = spinning(momentsOfBox(halfExtents), spin);
    RungeKutta truth(body);
    const Vec3 start = body.momentum;
    const double before = energy(body.principal, start);
    for (int i = 0; i < 600; ++i) {
        body.turn(1.0 / 60);
        truth.advance(1.0 / 60, 200);
        ASSERT_LT(angleBetween(truth.orientation(), body.orientation), 1e-9) << i;
        // L and its energy are rounded 600 times.
        ASSERT_NEAR(energy(body.principal, body.momentum) / before, 1, 1e-12) << i;
        ASSERT_LT((body.orientation * body.momentum - start).norm(), 1e-12 * start.norm()) << i;
    }
}

TEST(FreeRotation, OfABoxThatFlipsAboutItsMiddleAxis) {
    tumble({0.1, 0.3, 0.5}, {0.01, 5, 0.01});
}

TEST(FreeRotation, OfARodThatTumbles) {
    tumble({0.05, 0.05, 1}, {3, 0, 6});
}

TEST(RotationVector, IsAxisTimesAngle) {
    Random random(12);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 axis = random.direction();
        const double angle = pi * std::pow(10, random.uniform(-20, 0));
        Quaterniond rotation(Eigen::AngleAxisd(angle, axis));
        if (random.coin()) rotation.coeffs() *= -1;
        EXPECT_LT((rotationVector(rotation) - angle * axis).norm(), 2e-15 * angle);
    }
}

TEST(RotationVector, HasAnAngleOfAtMostPi) {
    EXPECT_EQ(rotationVector(Quaterniond::Identity()), Vec3::Zero());
    EXPECT_EQ(rotationVector(Quaterniond(-1, 0, 0, 0)), Vec3::Zero());
    EXPECT_LT(
        (rotationVector(Quaterniond(Eigen::AngleAxisd(1.5 * pi, Vec3::UnitX()))) + 0.5 * pi * Vec3::UnitX())
            .norm(),
        1e-15 * pi);
    EXPECT_DOUBLE_EQ(rotationVector(Quaterniond(0, 0, 1, 0)).norm(), pi);
    EXPECT_EQ(rotationVector(Quaterniond(1, 0, 1e-300, 0)), Vec3(0, 2e-300, 0));
}

}  // namespace
}  // namespace bullet_buoyancy::test
