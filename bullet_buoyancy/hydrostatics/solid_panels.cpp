#include "bullet_buoyancy/hydrostatics/solid_panels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/core/quadrature.h"

namespace bullet_buoyancy {

namespace {

/// A part of the curve that is turned about the axis, as a function of a parameter t in which the radius is
/// smooth even at a pole, where it goes like a square root along the axis.
class Profile {
public:
    /// Part of a circle has x = sin t, even where it ends short of a pole; of other curves those that have a
    /// pole at one end, or at both, as a quarter or half of one.
    static Profile side(const ProfilePiece& piece) {
        if (piece.c2 < 0) return arc(piece);
        const bool fromPole = isPole(piece, piece.begin, 1), toPole = isPole(piece, piece.end, -1);
        const double length = piece.end - piece.begin;
        Profile profile;
        profile.m_piece = piece;
        if (fromPole && toPole)
            profile.setSine((piece.begin + piece.end) / 2, length / 2, -pi / 2, pi / 2);
        else if (fromPole)
            profile.setSine(piece.end, length, -pi / 2, 0);
        else if (toPole)
            profile.setSine(piece.begin, length, 0, pi / 2);
        else
            profile.setLinear(piece.begin, length);
        return profile;
    }

    /// Of a circle, or an ellipse.
    static Profile arc(const ProfilePiece& piece) {
        const double centre = -piece.c1 / (2 * piece.c2);
        const double half = std::sqrt(std::max(0.0, centre * centre - piece.c0 / piece.c2));
        const auto angle = [&](double x) { return std::asin(std::clamp((x - centre) / half, -1.0, 1.0)); };
        Profile profile;
        profile.m_piece = piece;
        if (half > 0)
            profile.setSine(centre, half, angle(piece.begin), angle(piece.end));
        else
            profile.setLinear(piece.begin, piece.end - piece.begin);
        return profile;
    }

    /// A flat end. Outward is along the axis where the radius falls.
    static Profile disc(double x, double from, double to) {
        Profile profile;
        profile.setLinear(x, 0);
        profile.m_isDisc = true;
        profile.m_from = from;
        profile.m_rise = to - from;
        return profile;
    }

    struct Point {
        double x, radius;
        double radiusTimesDx, radiusTimesSlope;  // radius times the derivatives of x and radius
    };

    Point at(double t) const {
        if (m_isDisc) {
            const double radius = m_from + t * m_rise;
            return {m_middle, radius, 0, radius * m_rise};
        }
        const double x = m_middle + m_scale * (m_isSine ? std::sin(t) : t);
        const double dx = m_scale * (m_isSine ? std::cos(t) : 1);
        const double radius = std::sqrt(std::max(0.0, m_piece.radiusSquared(x)));
        return {x, radius, radius * dx, (m_piece.c1 / 2 + x * m_piece.c2) * dx};
    }

    double begin() const { return m_begin; }
    double end() const { return m_end; }

    /// Panels to begin with.
    int parts() const { return m_isSine ? std::max(1, int(std::lround((m_end - m_begin) / (pi / 4)))) : 1; }

private:
    /// Whether the radius vanishes there as a sphere's does, not as a cone's.
    static bool isPole(const ProfilePiece& piece, double x, double inward) {
        const double length = piece.end - piece.begin,
                     middle2 = piece.radiusSquared((piece.begin + piece.end) / 2);
        constexpr double vanishing = 1e-9, clearly = 0.1;
        return piece.radiusSquared(x) <= vanishing * middle2 &&
               inward * (piece.c1 + 2 * x * piece.c2) * length > clearly * middle2;
    }

    void setSine(double middle, double scale, double begin, double end) {
        m_isSine = true;
        m_middle = middle;
        m_scale = scale;
        m_begin = begin;
        m_end = end;
    }

    void setLinear(double begin, double length) {
        m_middle = begin;
        m_scale = length;
    }

    bool m_isSine = false, m_isDisc = false;
    double m_middle = 0, m_scale = 0, m_begin = 0, m_end = 1;
    double m_from = 0, m_rise = 0;
    ProfilePiece m_piece{};
};

/// Of one parameter.
struct Range {
    double begin, end;

    double length() const { return end - begin; }
    double at(double share) const { return begin + share * (end - begin); }
};

/// In rising order: the ends of a range, and up to six places between them.
struct Stops {
    std::array<double, 8> at{};
    std::size_t count = 2;

    explicit Stops(const Range& range) : at{range.begin, range.end} {}

    void insert(double value) {
        std::size_t i = count++;
        for (; at[i - 1] > value; --i)
            at[i] = at[i - 1];
        at[i] = value;
    }
};

/// A rectangle of the two parameters: of the profile and the angle about the axis.
struct Panel {
    Range t, angle;
};

struct Element {
    Vec3 position;
    Vec3 density;  // along the outward normal, m^2 per unit of the parameters' area
};

/// Along a line of values at both ends and the middle: a parabola's slopes at the ends, per line.
struct Slopes {
    double atBegin, atEnd;
};

Slopes slopesOf(double first, double middle, double last) {
    return {-3 * first + 4 * middle - last, first - 4 * middle + 3 * last};
}

/// Where such a parabola turns, as a share of the line; the middle if it does not turn on it.
double vertexOf(const std::array<double, 3>& f) {
    const double slope = -3 * f[0] + 4 * f[1] - f[2], bend = 4 * (f[0] - 2 * f[1] + f[2]);
    const bool turns = slope * bend < 0 && std::abs(slope) < std::abs(bend);
    return turns ? -slope / bend : 0.5;
}

using Grid = std::array<std::array<double, 3>, 3>;  // at the corners, the middles of sides and the middle

Grid transposed(const Grid& g) {
    Grid result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = g[j][i];
    return result;
}

/// Largest second difference along the second index.
double bendOf(const Grid& g) {
    double bend = 0;
    for (const std::array<double, 3>& line : g)
        bend = std::max(bend, std::abs(line[0] - 2 * line[1] + line[2]));
    return bend;
}

/// By how much a biquadratic through nine values may be beyond the least and the most of them, with as much
/// again for what is not quadratic.
double beyond(const Grid& g) {
    return std::max(bendOf(g), bendOf(transposed(g))) / 2;
}

/// How the depth changes along the lines of a panel.
struct Steepness {
    double least;  // if above zero, all change the same way, this fast or faster
    double most;
};

/// Of a biquadratic along the second index: at the ends of lines, which are parabolas in the first.
Steepness steepnessOf(const Grid& g) {
    std::array<double, 3> begin, end;
    for (std::size_t i = 0; i < 3; ++i) {
        const Slopes slopes = slopesOf(g[i][0], g[i][1], g[i][2]);
        begin[i] = slopes.atBegin;
        end[i] = slopes.atEnd;
    }
    double least = std::min(begin[0], end[0]), most = std::max(begin[0], end[0]);
    for (const std::array<double, 3>& s : {begin, end}) {
        const double between = std::abs(s[0] - 2 * s[1] + s[2]) / 8;
        least = std::min(least, std::min({s[0], s[1], s[2]}) - between);
        most = std::max(most, std::max({s[0], s[1], s[2]}) + between);
    }
    return least > 0 ? Steepness{least, most} : Steepness{-most, -least};
}

double areaOf(const RoundBody& body) {
    const auto disc = [](const ProfilePiece& piece, double x) {
        return pi * std::max(0.0, piece.radiusSquared(x));
    };
    double area = disc(*body.begin, body.begin->begin) + disc(*(body.end - 1), (body.end - 1)->end);
    for (const ProfilePiece* piece = body.begin; piece != body.end; ++piece)
        area += 2 * pi * (piece->end - piece->begin) *
                piece->radiusTimesArcLength((piece->begin + piece->end) / 2);
    return area;
}

/// Over a sixth of a turn four nodes are good for seven digits of a sine; but not of the secant, by which the
/// waterline crosses a flat end.
constexpr std::size_t few = 4, many = 8;

/// Of the quadrature, over the largest head or, where a panel is cut, the range of heads.
constexpr double errorOfMany = 1e-6, errorOfFew = 5e-5;

template <std::size_t order>
const GaussLegendre<order>& gaussRule() {
    static const GaussLegendre<order> rule;
    return rule;
}

class Panels {
public:
    Panels(const RoundBody& body, const WaterPatch& water, double headError, const HydrostaticQuery& query,
           WetIntegrals& integrals)
        : m_body(body),
          m_water(water),
          m_headError(headError),
          m_query(query),
          m_integrals(integrals),
          m_first(body.axis.unitOrthogonal()),
          m_second(body.axis.cross(m_first)),
          m_allowedAtTouch(headError * areaOf(body) / 50) {}

    void add() {
        for (const ProfilePiece* piece = m_body.begin; piece != m_body.end; ++piece)
            add(Profile::side(*piece));
        const ProfilePiece &first = *m_body.begin, &last = *(m_body.end - 1);
        const double begins = first.radiusSquared(first.begin), ends = last.radiusSquared(last.end);
        if (begins > 0) add(Profile::disc(first.begin, 0, std::sqrt(begins)));
        if (ends > 0) add(Profile::disc(last.end, std::sqrt(ends), 0));
    }

private:
    static constexpr int mostHalvings = 14;
    static constexpr double reachingOver = 0.7;  // of the error allowed

    void add(const Profile& profile) {
        m_profile = &profile;
        constexpr int round = 6;
        const Range t{profile.begin(), profile.end()};
        const int parts = profile.parts();
        for (int i = 0; i < parts; ++i)
            for (int j = 0; j < round; ++j)
                add({{t.at(double(i) / parts), t.at(double(i + 1) / parts)},
                     {2 * pi * j / round, 2 * pi * (j + 1) / round}},
                    0);
    }

    bool isHydrostatic() const { return m_water.pressure() == PressureModel::hydrostatic; }

    Vec3 outwardAt(double angle) const { return std::cos(angle) * m_first + std::sin(angle) * m_second; }

    Element element(const Profile::Point& p, const Vec3& outward) const {
        return {m_body.origin + p.x * m_body.axis + p.radius * outward,
                p.radiusTimesDx * outward - p.radiusTimesSlope * m_body.axis};
    }

    /// What a panel is like, by nine points of it.
    struct Sight {
        const WaterExpansion* water;
        Grid depth;
        double least, most;         // depth
        double largestError;        // of the expansion
        Vec3 error = Vec3::Zero();  // of the expansion, over the panel
        Vec3 area = Vec3::Zero();   // of the projections' absolute values
        Vec3 size;                  // along the body's axes
        bool isLong;                // along the profile
    };

    Sight look(const Panel& panel) const {
        std::array<std::array<Element, 3>, 3> elements;
        const std::array<Vec3, 3> outward{outwardAt(panel.angle.begin), outwardAt(panel.angle.at(0.5)),
                                          outwardAt(panel.angle.end)};
        for (std::size_t i = 0; i < 3; ++i) {
            const Profile::Point p = m_profile->at(panel.t.at(double(i) / 2));
            for (std::size_t j = 0; j < 3; ++j)
                elements[i][j] = element(p, outward[j]);
        }
        Sight sight;
        sight.water = &m_water.near(elements[1][1].position);
        sight.least = infinity;
        sight.most = -infinity;
        sight.largestError = 0;
        Vec3 low = elements[0][0].position, high = low;
        constexpr std::array<double, 3> simpson{1.0 / 6, 4.0 / 6, 1.0 / 6};
        const double area = panel.t.length() * panel.angle.length();
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const Element& e = elements[i][j];
                const double depth = sight.water->depthAt(e.position);
                const double error = m_water.errorAt(*sight.water, e.position);
                sight.depth[i][j] = depth;
                sight.least = std::min(sight.least, depth);
                sight.most = std::max(sight.most, depth);
                sight.largestError = std::max(sight.largestError, error);
                const Vec3 projected = area * simpson[i] * simpson[j] * e.density.cwiseAbs();
                sight.area += projected;
                sight.error += error * projected;
                low = low.cwiseMin(e.position);
                high = high.cwiseMax(e.position);
            }
        sight.size = high - low;
        sight.isLong = (elements[2][1].position - elements[0][1].position).squaredNorm() >
                       (elements[1][2].position - elements[1][0].position).squaredNorm();
        return sight;
    }

    void add(const Panel& panel, int halvings) {
        const Sight sight = look(panel);
        const double bulge = beyond(sight.depth);
        if (sight.most + bulge + sight.largestError <= 0) return;
        const bool mayHalve = halvings < mostHalvings;
        if (mayHalve && sight.error.norm() > reachingOver * m_headError * sight.area.norm() &&
            isLargerThanACell(sight))
            return addHalves(panel, sight.isLong, halvings + 1);
        if (sight.most + bulge <= 0) return noteDry(sight);
        if (sight.least - bulge >= 0) return addWhole(panel, sight);

        const Steepness alongAngle = steepnessOf(sight.depth), alongT = steepnessOf(transposed(sight.depth));
        // The lines' ends are smooth functions where no line runs along the waterline.
        constexpr double steady = 0.2;
        if (alongAngle.least > steady * alongAngle.most) return addCut(panel, sight, true, alongAngle);
        if (alongT.least > steady * alongT.most) return addCut(panel, sight, false, alongT);
        const double dryDepth = bulge - sight.least, wetDepth = sight.most + bulge;
        const double leftOut = std::min(dryDepth, wetDepth);
        if (mayHalve && leftOut * sight.area.norm() > m_allowedAtTouch)
            return addHalves(panel, bendOf(transposed(sight.depth)) > bendOf(sight.depth), halvings + 1);
        m_integrals.lastingError += leftOut * sight.area;
        if (dryDepth < wetDepth)
            addWhole(panel, sight);
        else
            noteDry(sight);
    }

    bool isLargerThanACell(const Sight& sight) const {
        constexpr double rounding = 1e-9;
        return m_water.cellCount() > 1 && (sight.size - (1 + rounding) * m_water.cell()).maxCoeff() > 0;
    }

    void addHalves(const Panel& panel, bool acrossT, int halvings) {
        const Range& whole = acrossT ? panel.t : panel.angle;
        for (const Range& half : {Range{whole.begin, whole.at(0.5)}, Range{whole.at(0.5), whole.end}})
            add(acrossT ? Panel{half, panel.angle} : Panel{panel.t, half}, halvings);
    }

    void noteDry(const Sight& sight) { m_integrals.error += sight.error; }

    void addWhole(const Panel& panel, const Sight& sight) {
        m_integrals.error += sight.error;
        m_integrals.lastingError += errorOfMany * std::max(sight.most, -sight.least) * sight.area;
        std::array<Vec3, few> outward;
        for (std::size_t j = 0; j < few; ++j)
            outward[j] = outwardAt(panel.angle.at((1 + m_gauss.nodes[j]) / 2));
        const double area = panel.t.length() * panel.angle.length() / 4;
        for (std::size_t i = 0; i < few; ++i) {
            const Profile::Point p = m_profile->at(panel.t.at((1 + m_gauss.nodes[i]) / 2));
            for (std::size_t j = 0; j < few; ++j) {
                const Element e = element(p, outward[j]);
                addElement(*sight.water, e.position,
                           area * m_gauss.weights[i] * m_gauss.weights[j] * e.density);
            }
        }
    }

    void addElement(const WaterExpansion& water, const Vec3& position, const Vec3& areaVector) {
        const Vec3& up = m_water.upInBody();
        const double depth = water.depthAt(position), head = isHydrostatic() ? depth : water.headAt(position);
        const double areaUp = areaVector.dot(up);
        m_integrals.headNormal += head * areaVector;
        m_integrals.headTorque += head * position.cross(areaVector);
        m_integrals.volume -= depth * areaUp;
        m_integrals.volumeMoment -= areaUp * depth * (position + depth / 2 * up);
        m_integrals.headVolume -= areaUp / 2 * depth * head;
        if (m_query.wettedArea) m_integrals.wettedArea += areaVector.norm();
        if (m_query.needsWaterplane())
            m_integrals.addWaterplane(-areaUp, position + depth * up, Mat3::Zero());
    }

    /// Across a panel: round the axis at one place of the profile, or along the profile at one angle.
    class Line {
    public:
        Line(const Panels& panels, bool isRound, double place) : m_panels(panels), m_isRound(isRound) {
            if (isRound)
                m_point = panels.m_profile->at(place);
            else
                m_outward = panels.outwardAt(place);
        }

        Element at(double l) const {
            return m_isRound ? m_panels.element(m_point, m_panels.outwardAt(l))
                             : m_panels.element(m_panels.m_profile->at(l), m_outward);
        }

    private:
        const Panels& m_panels;
        bool m_isRound;
        Profile::Point m_point;
        Vec3 m_outward;
    };

    struct DepthOnEdge {
        double place, depth;
    };

    /// Where the waterline leaves the panel at an end of the lines: there their wet part has a kink.
    Stops kinks(const Panel& panel, const Sight& sight, bool areRound) const {
        const Range across = areRound ? panel.t : panel.angle, along = areRound ? panel.angle : panel.t;
        const Grid depth = areRound ? transposed(sight.depth) : sight.depth;
        Stops stops(across);
        for (const auto& [place, atEnds] :
             {std::pair(along.begin, depth[0]), std::pair(along.end, depth[2])}) {
            const Line edge(*this, !areRound, place);
            const auto depthAt = [&](double s) { return sight.water->depthAt(edge.at(s).position); };
            const double turn = across.at(vertexOf(atEnds)), middle = across.at(0.5),
                         depthAtTurn = depthAt(turn);
            const std::array<DepthOnEdge, 4> on{
                DepthOnEdge{across.begin, atEnds[0]},
                turn < middle ? DepthOnEdge{turn, depthAtTurn} : DepthOnEdge{middle, atEnds[1]},
                turn < middle ? DepthOnEdge{middle, atEnds[1]} : DepthOnEdge{turn, depthAtTurn},
                DepthOnEdge{across.end, atEnds[2]}};
            for (std::size_t i = 0; i + 1 < on.size(); ++i)
                if ((on[i].depth > 0) != (on[i + 1].depth > 0))
                    stops.insert(
                        rootOf(depthAt, {on[i].place, on[i + 1].place}, on[i].depth, on[i + 1].depth));
        }
        return stops;
    }

    /// Along lines on which the depth changes all one way.
    void addCut(const Panel& panel, const Sight& sight, bool areRound, const Steepness& steepness) {
        const Range across = areRound ? panel.t : panel.angle, along = areRound ? panel.angle : panel.t;
        const Stops stops = kinks(panel, sight, areRound);
        // Where some lines end at the waterline at a much smaller angle than others, their length goes like a
        // root, which takes more of them.
        const double range = sight.most - sight.least;
        const bool areFew = errorOfFew * range < m_headError / 16 && steepness.least > steepness.most / 2;
        m_integrals.lastingError += (areFew ? errorOfFew : errorOfMany) * range * sight.area;
        for (std::size_t i = 0; i + 1 < stops.count; ++i) {
            const Range between{stops.at[i], stops.at[i + 1]};
            if (areFew || between.length() < across.length() / 3)
                addLines<few>(areRound, between, along, *sight.water);
            else
                addLines<many>(areRound, between, along, *sight.water);
        }
        // Where the true surface is above an expansion's.
        m_integrals.error +=
            sight.largestError * std::min(1.0, sight.largestError / steepness.least) * sight.area;
    }

    template <std::size_t count>
    void addLines(bool areRound, const Range& across, const Range& along, const WaterExpansion& water) {
        if (!(across.length() > 0)) return;
        const GaussLegendre<count>& rule = gaussRule<count>();
        for (std::size_t i = 0; i < count; ++i) {
            const Line line(*this, areRound, across.at((1 + rule.nodes[i]) / 2));
            const auto depthAt = [&](double l) { return water.depthAt(line.at(l).position); };
            const double first = depthAt(along.begin), last = depthAt(along.end);
            if (first <= 0 && last <= 0) continue;
            Range wet = along;
            if (!(first > 0 && last > 0))
                (first > 0 ? wet.end : wet.begin) = rootOf(depthAt, along, first, last);
            const double weight = rule.weights[i] / 4 * across.length() * wet.length();
            for (std::size_t j = 0; j < few; ++j) {
                const Element e = line.at(wet.at((1 + m_gauss.nodes[j]) / 2));
                const Vec3 areaVector = weight * m_gauss.weights[j] * e.density;
                addElement(water, e.position, areaVector);
                m_integrals.error += m_water.errorAt(water, e.position) * areaVector.cwiseAbs();
            }
        }
    }

    /// False position with Anderson and Bjorck's reductions: the values at the ends have different signs.
    /// What remains matters by its square: the head is zero at the waterline.
    template <typename Function>
    static double rootOf(const Function& f, Range range, double first, double last) {
        constexpr int mostSteps = 20;
        const double small = 1e-6 * (std::abs(first) + std::abs(last));
        double root = range.begin;
        for (int step = 0; step < mostSteps; ++step) {
            root = range.begin + range.length() * first / (first - last);
            const double value = f(root);
            if (std::abs(value) <= small) break;
            double& replaced = (value > 0) == (last > 0) ? last : first;
            double& kept = &replaced == &last ? first : last;
            const double reduction = 1 - value / replaced;
            kept *= reduction > 0 ? reduction : 0.5;
            (&replaced == &last ? range.end : range.begin) = root;
            replaced = value;
        }
        return root;
    }

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    const RoundBody& m_body;
    const WaterPatch& m_water;
    double m_headError;
    const HydrostaticQuery& m_query;
    WetIntegrals& m_integrals;
    Vec3 m_first, m_second;
    const Profile* m_profile = nullptr;
    double m_allowedAtTouch;  // m^3
    const GaussLegendre<few>& m_gauss = gaussRule<few>();
};

}  // namespace

void addPanels(const RoundBody& body, const WaterPatch& water, double headError,
               const HydrostaticQuery& query, WetIntegrals& integrals) {
    Panels(body, water, headError, query, integrals).add();
}

}  // namespace bullet_buoyancy
