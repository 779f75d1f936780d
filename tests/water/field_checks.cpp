#include "water/field_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bullet_buoyancy/core/constants.h"
#include "support/near.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

namespace {

using Place = std::array<double, 5>;

double valueAt(const Target& target, const Place& p) {
    return target(p[0], p[1], p[2], p[3], std::clamp(p[4], 0.0, 1.0));
}

/// Random steps that shrink where they do not lead up.
double climb(const Target& target, Place place, double value, Random& random) {
    const Place scales{1, 1, 1, 0.5, 0.2};
    double size = 1;
    for (int step = 0; step < 400; ++step) {
        Place next = place;
        for (std::size_t i = 0; i < next.size(); ++i)
            next[i] += size * scales[i] * random.uniform(-1, 1);
        const double nextValue = valueAt(target, next);
        if (nextValue > value) {
            place = next;
            value = nextValue;
            size *= 1.5;
        } else {
            size = std::max(0.9 * size, 1e-4);
        }
    }
    return value;
}

}  // namespace

Eigen::Array3d surfaceAt(const WaterField& water, double x, double y, double time) {
    Eigen::ArrayX2d points(1, 2);
    points << x, y;
    Eigen::ArrayX3d samples(1, 3);
    water.sampleSurface(points, time, samples);
    return samples.row(0).transpose();
}

Eigen::Array<double, 7, 1> expansionAt(const WaterField& water, double x, double y, double time) {
    Eigen::ArrayX2d points(1, 2);
    points << x, y;
    Eigen::Array<double, Eigen::Dynamic, 7> expansions(1, 7);
    water.expandSurface(points, time, expansions);
    return expansions.row(0).transpose();
}

Eigen::Array<double, 10, 1> headAt(const WaterField& water, double x, double y, double s, double time) {
    Eigen::ArrayX3d points(1, 3);
    points << x, y, s;
    Eigen::Array<double, Eigen::Dynamic, 10> expansions(1, 10);
    water.expandWaveHead(points, time, expansions);
    return expansions.row(0).transpose();
}

Vec3 velocityAt(const WaterField& water, const Vec3& point, double time) {
    const Eigen::ArrayX3d points = point.transpose().array();
    Eigen::ArrayX3d velocities(1, 3);
    water.sampleVelocity(points, time, velocities);
    return velocities.row(0).transpose();
}

/// Along a step in any direction the second derivative in that direction changes by no more than the third
/// that is told, and its growth, allow.
void expectThirdDerivativeWithinBound(const WaterField& water, const Vec2& place, double t, Random& random) {
    const double angle = random.uniform(-pi, pi), length = std::exp(random.uniform(-6, 1));
    const Vec2 along(std::cos(angle), std::sin(angle)), end = place + length * along;
    const auto at = expansionAt(water, place.x(), place.y(), t),
               there = expansionAt(water, end.x(), end.y(), t);
    const auto second = [&](const Eigen::Array<double, 7, 1>& e) {
        return e[3] * along.x() * along.x() + 2 * e[4] * along.x() * along.y() + e[5] * along.y() * along.y();
    };
    const double growth = water.bounds().curvatureChangeGrowth;
    EXPECT_LE(std::abs(second(there) - second(at)), at[6] * length + growth * length * length / 2 + 1e-9);
    // Each component's part of the norm is its part of the bound.
    EXPECT_LE(at[6], water.bounds().curvatureChange * (1 + 1e-12));
}

void expectSurfaceDerivatives(const WaterField& water, const DerivativeCheck& check) {
    Random random(1);
    const double h = check.step;
    for (int i = 0; i < 200; ++i) {
        const double x = random.uniform(-check.halfSize, check.halfSize);
        const double y = random.uniform(-check.halfSize, check.halfSize), t = random.uniform(0, 100);
        const Eigen::Array3d sample = surfaceAt(water, x, y, t);
        const Eigen::Array<double, 7, 1> expansion = expansionAt(water, x, y, t);
        // Two ways of summing up, or of stopping a search, for the same.
        EXPECT_NEAR(expansion[0], sample[0], 1e-9);
        EXPECT_LE((expansion.segment<2>(1) - sample.tail<2>()).abs().maxCoeff(), 1e-8);
        const Eigen::Array3d byX = (surfaceAt(water, x + h, y, t) - surfaceAt(water, x - h, y, t)) / (2 * h);
        const Eigen::Array3d byY = (surfaceAt(water, x, y + h, t) - surfaceAt(water, x, y - h, t)) / (2 * h);
        EXPECT_NEAR(sample[1], byX[0], check.tolerance);
        EXPECT_NEAR(sample[2], byY[0], check.tolerance);
        EXPECT_NEAR(expansion[3], byX[1], check.tolerance);
        EXPECT_NEAR(expansion[4], byX[2], check.tolerance);
        EXPECT_NEAR(expansion[4], byY[1], check.tolerance);
        EXPECT_NEAR(expansion[5], byY[2], check.tolerance);
        expectThirdDerivativeWithinBound(water, {x, y}, t, random);
    }
}

void expectHeadDerivatives(const WaterField& water, const DerivativeCheck& check) {
    Random random(2);
    // Where the second derivative along axes i and j stands.
    const int second[3][3] = {{4, 5, 7}, {5, 6, 8}, {7, 8, 9}};
    for (int i = 0; i < 200; ++i) {
        const Vec3 place(random.uniform(-check.halfSize, check.halfSize),
                         random.uniform(-check.halfSize, check.halfSize), random.uniform(-6, 0.5));
        const double t = random.uniform(0, 100);
        const auto at = [&](const Vec3& p) { return headAt(water, p.x(), p.y(), p.z(), t); };
        const Eigen::Array<double, 10, 1> head = at(place);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = check.step * Vec3::Unit(axis);
            const Eigen::Array<double, 10, 1> by = (at(place + step) - at(place - step)) / (2 * check.step);
            EXPECT_NEAR(head[1 + axis], by[0], check.tolerance);
            for (int other = 0; other < 3; ++other)
                EXPECT_NEAR(head[second[axis][other]], by[1 + other], check.tolerance);
        }
        EXPECT_NEAR(headAt(water, place.x(), place.y(), 0, t)[0],
                    surfaceAt(water, place.x(), place.y(), t)[0], 1e-12);
    }
}

double searchLargest(const Target& target, double halfSize) {
    Random random(3);
    std::vector<std::pair<double, Place>> found;
    for (int i = 0; i < 1000; ++i) {
        const Place place{random.uniform(-halfSize, halfSize), random.uniform(-halfSize, halfSize),
                          random.uniform(0, 100), random.uniform(0, 2 * pi), random.uniform(0, 1)};
        found.emplace_back(valueAt(target, place), place);
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    double largest = 0;
    for (std::size_t i = 0; i < 5; ++i)
        largest = std::max(largest, climb(target, found[i].second, found[i].first, random));
    return largest;
}

WaterBounds searchBounds(const WaterField& water, double halfSize, bool thirdToo) {
    WaterBounds found;
    found.elevation = searchLargest(
        [&](double x, double y, double t, double, double) { return std::abs(surfaceAt(water, x, y, t)[0]); },
        halfSize);
    found.slope = searchLargest([&](double x, double y, double t, double,
                                    double) { return surfaceAt(water, x, y, t).tail<2>().matrix().norm(); },
                                halfSize);
    // Differences of slopes, for fields that do not tell more: off by step^2 / 6 times a fifth derivative at
    // most, or never above the second derivative's bound where it jumps.
    const double h = 1e-4;
    const auto along = [&](double x, double y, double t, double angle) {
        const Eigen::Array2d d(std::cos(angle), std::sin(angle));
        const auto slope = [&](double step) {
            return (surfaceAt(water, x + step * d[0], y + step * d[1], t).tail<2>() * d).sum();
        };
        return (slope(h) - slope(-h)) / (2 * h);
    };
    found.curvature = searchLargest(
        [&](double x, double y, double t, double angle, double) { return std::abs(along(x, y, t, angle)); },
        halfSize);
    found.curvatureChange = 0;
    if (thirdToo)
        found.curvatureChange = searchLargest(
            [&](double x, double y, double t, double angle, double) {
                const double dx = std::cos(angle), dy = std::sin(angle);
                const auto bend = [&](double step) {
                    const auto at = expansionAt(water, x + step * dx, y + step * dy, t);
                    return dx * dx * at[3] + 2 * dx * dy * at[4] + dy * dy * at[5];
                };
                return std::abs(bend(h) - bend(-h)) / (2 * h);
            },
            halfSize);
    return found;
}

double searchHeadCurvatureChange(const WaterField& water, double halfSize, double deepest, double above) {
    // A third difference of heads rounded to some 1e-15 m, over steps of 0.02 m: off by 1e-9 / m^2.
    const double h = 0.02;
    return searchLargest(
        [&](double x, double y, double t, double angle, double share) {
            // The angle also tells how steep the line is: 7 is no multiple of its period's parts.
            const double steep = 7 * angle, level = std::cos(steep);
            const Vec3 d(level * std::cos(angle), level * std::sin(angle), std::sin(steep));
            const double s = deepest + 0.1 + (above - deepest - 0.2) * share;
            const Vec3 place(x, y, surfaceAt(water, x, y, t)[0] + s);
            const auto head = [&](double step) {
                const Vec3 p = place + step * d;
                return -p.z() +
                       headAt(water, p.x(), p.y(), p.z() - surfaceAt(water, p.x(), p.y(), t)[0], t)[0];
            };
            return std::abs(head(2 * h) - 2 * head(h) + 2 * head(-h) - head(-2 * h)) / (2 * h * h * h);
        },
        halfSize);
}

}  // namespace bullet_buoyancy::test
