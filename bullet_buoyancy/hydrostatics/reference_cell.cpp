#include "bullet_buoyancy/hydrostatics/reference_cell.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/quadrature.h"
#include "bullet_buoyancy/hydrostatics/reference_element.h"

namespace bullet_buoyancy {

namespace {

using Corners = std::array<CellPoint, 3>;

bool isWet(double depth) {
    return depth > 0;
}

/// Gauss quadrature on [0, 1].
struct UnitRule {
    std::vector<double> nodes, weights;

    template <std::size_t n>
    static UnitRule gauss() {
        const GaussLegendre<n> rule;
        UnitRule result;
        for (std::size_t i = 0; i < n; ++i) {
            result.nodes.push_back((1 + rule.nodes[i]) / 2);
            result.weights.push_back(rule.weights[i] / 2);
        }
        return result;
    }
};

/// The cell with the corner first whose rays cross the waterline, if any do.
Corners withTipFirst(const Corners& c) {
    const bool a = isWet(c[0].depth), b = isWet(c[1].depth);
    if (b == isWet(c[2].depth)) return c;
    return a == b ? Corners{c[2], c[0], c[1]} : Corners{c[1], c[2], c[0]};
}

std::vector<double> depthsAt(const SurfacePatch& patch, const std::vector<Vec2>& parameters,
                             WaterAroundBody& water) {
    std::vector<Vec3> positions;
    for (const Vec2& p : parameters)
        positions.push_back(patch.at(p).position);
    return water.depths(positions);
}

/// A change of sign of the depth along a ray, closed in by false position (Anderson and Bjorck 1973).
struct Bracket {
    double from, fromDepth;
    double to, toDepth;

    double guess() const { return (from * toDepth - to * fromDepth) / (toDepth - fromDepth); }

    void take(double place, double depth) {
        if (isWet(depth) == isWet(toDepth)) {
            const double fraction = toDepth == 0 ? 0 : 1 - depth / toDepth;
            fromDepth *= fraction > 0 ? fraction : 0.5;
        } else {
            from = to;
            fromDepth = toDepth;
        }
        to = place;
        toDepth = depth;
    }
};

/// Where rays from the tip to points of the opposite side, at these fractions of it, cross the surface: as
/// fractions of the ray; 1 for those that do not.
std::vector<double> crossings(const SurfacePatch& patch, const Corners& c,
                              const std::vector<double>& fractions, WaterAroundBody& water) {
    const Vec2& tip = c[0].parameters;
    const auto count = fractions.size();
    std::vector<Vec2> rays(count), places(count);
    for (std::size_t i = 0; i < count; ++i) {
        places[i] = c[1].parameters + fractions[i] * (c[2].parameters - c[1].parameters);
        rays[i] = places[i] - tip;
    }
    std::vector<double> depths = depthsAt(patch, places, water), found(count, 1);
    const double enough = 1e-12 * (std::abs(c[0].depth) + std::abs(c[1].depth) + std::abs(c[2].depth));
    std::vector<Bracket> brackets(count);
    std::vector<bool> open(count);
    for (std::size_t i = 0; i < count; ++i) {
        brackets[i] = {0, c[0].depth, 1, depths[i]};
        open[i] = isWet(depths[i]) != isWet(c[0].depth);
    }
    constexpr int tries = 40;
    for (int k = 0; k < tries && std::find(open.begin(), open.end(), true) != open.end(); ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            if (open[i]) found[i] = brackets[i].guess();
            places[i] = tip + found[i] * rays[i];
        }
        depths = depthsAt(patch, places, water);
        for (std::size_t i = 0; i < count; ++i) {
            if (!open[i]) continue;
            brackets[i].take(found[i], depths[i]);
            open[i] = std::abs(depths[i]) > enough;
        }
    }
    return found;
}

/// Points with their weights: area in the parameters.
struct WeightedPoints {
    std::vector<Vec2> parameters;
    std::vector<double> weights;
};

WeightedPoints pointsOfWetPart(const SurfacePatch& patch, const Corners& c, const UnitRule& rule,
                               WaterAroundBody& water) {
    const Vec2 &tip = c[0].parameters, side = c[2].parameters - c[1].parameters;
    const Vec2 first = c[1].parameters - tip;
    const double doubleArea = std::abs(first.x() * side.y() - first.y() * side.x());
    const bool tipIsWet = isWet(c[0].depth), isCut = tipIsWet != isWet(c[1].depth);
    const std::vector<double> cuts =
        isCut ? crossings(patch, c, rule.nodes, water) : std::vector<double>(rule.nodes.size(), 1);
    WeightedPoints points;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const Vec2 ray = first + rule.nodes[i] * side;
        const double begin = isCut && !tipIsWet ? cuts[i] : 0, end = isCut && !tipIsWet ? 1 : cuts[i];
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const double place = begin + (end - begin) * rule.nodes[j];
            points.parameters.emplace_back(tip + place * ray);
            points.weights.push_back(doubleArea * rule.weights[i] * rule.weights[j] * (end - begin) * place);
        }
    }
    return points;
}

WetIntegrals integrate(const SurfacePatch& patch, const Corners& c, const UnitRule& rule,
                       WaterAroundBody& water) {
    const WeightedPoints points = pointsOfWetPart(patch, c, rule, water);
    std::vector<Vec3> positions, areaVectors;
    for (std::size_t i = 0; i < points.weights.size(); ++i) {
        const PatchPoint point = patch.at(points.parameters[i]);
        positions.push_back(point.position);
        areaVectors.push_back(points.weights[i] * point.areaVector);
    }
    const std::vector<double> depths = water.depths(positions), heads = water.heads(positions, depths);
    const Vec3 up = water.upInBody();
    WetIntegrals sums;
    for (std::size_t i = 0; i < depths.size(); ++i)
        if (isWet(depths[i])) addElement(positions[i], depths[i], heads[i], areaVectors[i], up, sums);
    return sums;
}

/// The share of a triangle's area on which a linear function with these ascending corner values is below a
/// level.
double shareBelow(const std::array<double, 3>& v, double level) {
    if (level <= v[0]) return 0;
    if (level >= v[2]) return 1;
    if (level <= v[1]) return (level - v[0]) * (level - v[0]) / ((v[1] - v[0]) * (v[2] - v[0]));
    return 1 - (v[2] - level) * (v[2] - level) / ((v[2] - v[1]) * (v[2] - v[0]));
}

/// How far the depth is from linear interpolation between the corners, at most. Between corners v_i with
/// weights w_i that is 1/2 sum w_i q(v_i - x) for a second derivative bounded by the quadratic form q; and
/// sum w_i q(v_i - x) = sum over the sides of w_i w_j q(side), at most a third of the largest q(side).
double departureFromLinear(const SurfacePatch& patch, const Cell& cell, const WaterAroundBody& water) {
    const ParameterTriangle triangle{cell.corners[0].parameters, cell.corners[1].parameters,
                                     cell.corners[2].parameters};
    double most = 0, seen = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const StepBounds side = patch.alongStep(triangle, triangle[next] - triangle[i]);
        most = std::max(most, water.curvature() * side.lengthSquared + water.steepness() * side.bend);
        const double ends = cell.corners[i].depth + cell.corners[next].depth;
        seen = std::max(seen, 4 * std::abs(ends - 2 * cell.middles[i].depth));
    }
    return std::min(most, std::max(2 * seen, most / 8)) / 6;
}

/// The share of a cell's area on which the waterline may run otherwise than its corners and rays tell; the
/// depth there is no more than two departures.
///
/// Along a ray from the tip of a cut cell the depth changes by more than its slope can depart from linear
/// (half of q along the ray, an eighth of q along the opposite side; the departure is q / 6) in all cells but
/// the coarsest: it crosses the surface once and where it was found to. What is left is a kink in the
/// waterline where it touches the opposite side, from which a corner is clear by an eighth of q.
double shareInDoubt(const Corners& c, double departure) {
    const double change = std::min(std::abs(c[1].depth - c[0].depth), std::abs(c[2].depth - c[0].depth));
    if (isWet(c[0].depth) != isWet(c[1].depth) && change > 3.75 * departure) {
        const auto [less, more] = std::minmax({std::abs(c[1].depth), std::abs(c[2].depth)});
        const double reach = 0.75 * departure;
        if (less >= reach) return 0;
        const double ofSide = more > reach ? (reach - less) / (more - less) : 1;
        return ofSide * std::min(1.0, 4 * reach / change);
    }
    std::array<double, 3> depths{c[0].depth, c[1].depth, c[2].depth};
    std::sort(depths.begin(), depths.end());
    return shareBelow(depths, departure) - shareBelow(depths, -departure);
}

double areaOf(const SurfacePatch& patch, const Corners& c) {
    const Vec2 u = c[1].parameters - c[0].parameters, v = c[2].parameters - c[0].parameters;
    const double ofParameters = std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
    return ofParameters * patch.at(c[0].parameters + (u + v) / 3).areaVector.norm();
}

}  // namespace

Cell makeCell(const SurfacePatch& patch, const std::array<CellPoint, 3>& corners, WaterAroundBody& water) {
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < 3; ++i)
        places.emplace_back((corners[i].parameters + corners[(i + 1) % 3].parameters) / 2);
    const std::vector<double> depths = depthsAt(patch, places, water);
    return {corners, {CellPoint{places[0], depths[0]}, {places[1], depths[1]}, {places[2], depths[2]}}};
}

std::array<Cell, 4> quarters(const SurfacePatch& patch, const Cell& cell, WaterAroundBody& water) {
    const auto& [a, b, c] = cell.corners;
    const auto& [ab, bc, ca] = cell.middles;
    return {makeCell(patch, {a, ab, ca}, water), makeCell(patch, {ab, b, bc}, water),
            makeCell(patch, {ca, bc, c}, water), makeCell(patch, {ab, bc, ca}, water)};
}

CellDoubt doubtOf(const SurfacePatch& patch, const Cell& cell, const WaterAroundBody& water) {
    const double departure = departureFromLinear(patch, cell, water);
    const Corners c = withTipFirst(cell.corners);
    const auto isDry = [&](const CellPoint& corner) { return corner.depth < -departure; };
    if (std::all_of(c.begin(), c.end(), isDry)) return {0, 0, true};
    const double share = shareInDoubt(c, departure);
    return {share > 0 ? share * areaOf(patch, c) : 0, 2 * departure, false};
}

WetIntegrals integrateWetPart(const SurfacePatch& patch, const Cell& cell, CellRule rule,
                              WaterAroundBody& water) {
    static const UnitRule three = UnitRule::gauss<3>(), five = UnitRule::gauss<5>(),
                          eight = UnitRule::gauss<8>();
    return integrate(patch, withTipFirst(cell.corners),
                     rule == CellRule::three  ? three
                     : rule == CellRule::five ? five
                                              : eight,
                     water);
}

}  // namespace bullet_buoyancy
