#include "bullet_buoyancy/hydrostatics/reference_cell.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/core/quadrature.h"
#include "bullet_buoyancy/hydrostatics/reference_element.h"

namespace bullet_buoyancy {

namespace {

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
CellCorners withTipFirst(const CellCorners& c) {
    const bool a = isWet(c[0].depth), b = isWet(c[1].depth);
    if (b == isWet(c[2].depth)) return c;
    return a == b ? CellCorners{c[2], c[0], c[1]} : CellCorners{c[1], c[2], c[0]};
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
std::vector<double> crossings(const SurfacePatch& patch, const CellCorners& c,
                              const std::vector<double>& fractions, WaterAroundBody& water) {
    const Vec2& tip = c[0].parameters;
    const auto count = fractions.size();
    std::vector<Vec2> rays(count), places(count);
    for (std::size_t i = 0; i < count; ++i) {
        places[i] = c[1].parameters + fractions[i] * (c[2].parameters - c[1].parameters);
        rays[i] = places[i] - tip;
    }
    std::vector<double> depths = depthsAt(patch, places, water), found(count, 1);
    const double enough = 1e-14 * (std::abs(c[0].depth) + std::abs(c[1].depth) + std::abs(c[2].depth));
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

WeightedPoints pointsOfWetPart(const SurfacePatch& patch, const CellCorners& c, const UnitRule& rule,
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

WetIntegrals integrate(const SurfacePatch& patch, const CellCorners& c, const UnitRule& rule,
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
double departureFromLinear(const SurfacePatch& patch, const CellCorners& c, const WaterAroundBody& water) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const StepBounds side = patch.alongStep(c[(i + 1) % 3].parameters - c[i].parameters);
        most = std::max(most, water.curvature() * side.lengthSquared + water.steepness() * side.bend);
    }
    return most / 6;
}

/// Whether all rays from the tip cross the surface once, on the safe side: the depth changes along a ray by
/// more than its slope can depart from linear (half of q along it, an eighth of q along the opposite side;
/// departure is q / 6), and the opposite side lies clear of the surface by its eighth.
bool crossesEachRayOnce(const CellCorners& c, double departure) {
    const double change = std::min(std::abs(c[1].depth - c[0].depth), std::abs(c[2].depth - c[0].depth));
    const double clearance = std::min(std::abs(c[1].depth), std::abs(c[2].depth));
    return change > 3.75 * departure && clearance > 0.75 * departure;
}

void noteDoubt(const SurfacePatch& patch, const CellCorners& c, double departure, CellIntegral& integral) {
    if (isWet(c[0].depth) != isWet(c[1].depth) && crossesEachRayOnce(c, departure)) return;
    std::array<double, 3> depths{c[0].depth, c[1].depth, c[2].depth};
    std::sort(depths.begin(), depths.end());
    const double share = shareBelow(depths, departure) - shareBelow(depths, -departure);
    const Vec2 u = c[1].parameters - c[0].parameters, v = c[2].parameters - c[0].parameters;
    const Vec2 centre = c[0].parameters + (u + v) / 3;
    const double parameterArea = std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
    integral.areaInDoubt = share * parameterArea * patch.at(centre).areaVector.norm();
    integral.depthInDoubt = 2 * departure;
}

}  // namespace

CellIntegral integrateCell(const SurfacePatch& patch, const CellCorners& corners, WaterAroundBody& water) {
    static const UnitRule fine = UnitRule::gauss<6>(), rough = UnitRule::gauss<4>();
    const CellCorners c = withTipFirst(corners);
    const double departure = departureFromLinear(patch, c, water);
    const auto isDry = [&](const CellCorner& corner) { return corner.depth < -departure; };
    CellIntegral integral;
    if (std::all_of(c.begin(), c.end(), isDry)) return integral;
    integral.value = integrate(patch, c, fine, water);
    integral.rougher = integrate(patch, c, rough, water);
    noteDoubt(patch, c, departure, integral);
    return integral;
}

}  // namespace bullet_buoyancy
