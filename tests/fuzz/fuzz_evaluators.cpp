// Sound hulls in any pose, in still water and in waves: all evaluators have the same answer, and one that can
// be true.

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hull/convex_hull.h"
#include "bullet_buoyancy/hull/place_part.h"
#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_batch.h"
#include "bullet_buoyancy/hydrostatics/evaluate_clustered.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "fuzz/check_hull.h"
#include "fuzz/choices.h"
#include "fuzz/input.h"
#include "support/compare_results.h"
#include "support/known_solids.h"

namespace bullet_buoyancy::fuzz {
namespace {

/// From `least` to `most`, both above 0, each factor as likely as another.
double magnitude(Input& input, double least, double most) {
    return least * std::pow(most / least, (input.unit() + 1) / 2);
}

Vec3 sizes(Input& input) {
    const double x = magnitude(input, 0.05, 5), y = magnitude(input, 0.05, 5);
    return {x, y, magnitude(input, 0.05, 5)};
}

TriangleMesh cloudHull(Input& input) {
    const Vec3 size = sizes(input);
    std::vector<Vec3> points;
    for (int i = 4 + input.index(20); i > 0; --i)
        points.push_back(size.cwiseProduct(input.inCube()));
    return convexHull(points);
}

/// Large enough for clusters of clusters.
TriangleMesh bumpyBall(Input& input) {
    TriangleMesh mesh = tessellate(Sphere{Vec3::Zero(), 1}, 2 + input.index(2));
    const Vec3 size = sizes(input), along = 3 * input.inCube();
    for (Vec3& vertex : mesh.vertices)
        vertex = size.cwiseProduct((1 + 0.3 * std::sin(along.dot(vertex))) * vertex);
    return mesh;
}

HullPart readPart(Input& input) {
    switch (input.index(evaluatedParts)) {
        case boxPart:
            return test::boxMesh(sizes(input));
        case ringPart: {
            const Vec3 size = sizes(input);
            return test::ringMesh(size.x(), size.x() + size.y(), size.z(), 3 + input.index(20));
        }
        case bumpyPart:
            return bumpyBall(input);
        case spherePart:
            return Sphere{Vec3::Zero(), magnitude(input, 0.05, 5)};
        case cylinderPart: {
            const Vec3 size = sizes(input);
            return makeCylinder(Vec3::Zero(), Vec3::UnitZ(), size.x(), size.y());
        }
        case conePart: {
            const Vec3 size = sizes(input);
            return makeCone(Vec3::Zero(), Vec3::UnitZ(), size.x(), size.y());
        }
        case capsulePart: {
            const Vec3 size = sizes(input);
            const double length = std::abs(size.x() - size.y()) + size.z();
            return makeTaperedCapsule(Vec3::Zero(), size.x(), length * Vec3::UnitX(), size.y());
        }
        default:
            return cloudHull(input);
    }
}

Eigen::Quaterniond readTurn(Input& input) {
    const Vec3 axis = input.inCube();
    return Eigen::Quaterniond(input.unit() + 1e-3, axis.x(), axis.y(), axis.z()).normalized();
}

HullResult readHull(Input& input) {
    std::vector<HullPart> parts;
    for (int i = 1 + input.index(3); i > 0; --i) {
        const HullPart part = readPart(input);
        Pose pose;
        pose.orientation = readTurn(input);
        pose.position = 3 * input.inCube();
        parts.push_back(placed(part, pose));
    }
    return makeHull(std::move(parts));
}

HydrostaticQuery readQuery(Input& input) {
    HydrostaticQuery query;
    const int extras = input.byte();
    query.wettedArea = extras & 1;
    query.waterplane = extras & 2;
    query.stiffness = extras & 4;
    query.time = 10 * input.unit();
    return query;
}

WaterFrame readFrame(Input& input) {
    const Vec3 up = input.inCube();
    return WaterFrame::fromUp(10 * input.inCube(), up.norm() > 0.1 ? up : Vec3::UnitZ());
}

struct Case {
    const Hull& hull;
    Pose pose;
    HydrostaticQuery query;

    double volume() const { return hull.moments.volume; }
    double size() const { return hull.bounds.radius + hull.bounds.centre.norm(); }

    /// Of a result over what the whole hull would have: some hundred operations on depths and areas, of which
    /// a thin hull has much for its volume, and where there are round solids their quadrature.
    double rounding() const {
        return 1e-13 * hull.surfaceArea * size() / volume() + (hull.solids.empty() ? 0 : 4e-8);
    }

    /// N, of water of the density.
    double weight(double density) const { return density * query.gravity * volume(); }
};

using Evaluator = HydrostaticResult (*)(const Hull&, const Pose&, const WaterField&, const HydrostaticQuery&);

constexpr Evaluator others[] = {evaluateBatch, evaluateClustered, evaluate};

void checkSame(const HydrostaticResult& a, const HydrostaticResult& b, const Case& c, double density) {
    const double off = test::relativeDifference(a, b, c.hull, density * c.query.gravity);
    BUOYANCY_EXPECT(off <= c.rounding(), "%g, rounding is %g", off, c.rounding());
    if (c.query.wettedArea || c.query.needsWaterplane()) {
        const double area = test::relativeAreaDifference(a, b, c.hull);
        BUOYANCY_EXPECT(area <= 1e-12 + 10 * c.rounding(), "%g, rounding is %g", area, c.rounding());
    }
}

void checkPossible(const HydrostaticResult& r, const Case& c, const FlatWater& water) {
    const double share = r.submergedVolume / c.volume(), rounding = c.rounding();
    BUOYANCY_EXPECT(share >= -rounding && share <= 1 + rounding, "%.17g of the hull is wet", share);
    const Vec3 lift = water.density() * c.query.gravity * r.submergedVolume * water.frame().upWorld();
    const double off = (r.forceWorld - lift).norm() / c.weight(water.density());
    BUOYANCY_EXPECT(off <= 2 * rounding, "the force is off by %g, rounding is %g", off, rounding);
    const double depth = r.potentialEnergy / (c.weight(water.density()) * c.size());
    BUOYANCY_EXPECT(depth >= -rounding, "a mean depth of %g", depth);
    if (!c.query.wettedArea) return;
    const double area = r.wettedArea / c.hull.surfaceArea;
    BUOYANCY_EXPECT(area >= -1e-5 && area <= 1 + 1e-5, "%.17g of the surface is wet", area);
}

/// What is under the plane and what is above it make the whole.
void checkComplement(const HydrostaticResult& wet, const Case& c, const FlatWater& water) {
    const WaterFrame& frame = water.frame();
    const FlatWater above(WaterFrame::fromUp(frame.originWorld(), -frame.upWorld()));
    const HydrostaticResult dry = evaluateExact(c.hull, c.pose, above, c.query);
    const double volume = wet.submergedVolume + dry.submergedVolume;
    BUOYANCY_EXPECT(std::abs(volume / c.volume() - 1) <= 2 * c.rounding(), "%g of %g m^3", volume,
                    c.volume());
    const Vec3 moment =
        wet.submergedVolume * wet.centreOfBuoyancyFromCom + dry.submergedVolume * dry.centreOfBuoyancyFromCom;
    const double off = (moment - c.pose.orientation * c.hull.moments.firstMoment).norm();
    BUOYANCY_EXPECT(off <= 2 * c.rounding() * c.volume() * c.size(), "%g of %g m^4", off,
                    c.volume() * c.size());
}

void checkSingle(const HydrostaticResult& full, const Case& c, const FlatWater& water) {
    HydrostaticQuery query = c.query;
    query.precision = Precision::single;
    for (Evaluator evaluator : {evaluateBatch, evaluateClustered}) {
        const HydrostaticResult single = evaluator(c.hull, c.pose, water, query);
        const double off = (single.forceWorld - full.forceWorld).norm();
        const double allowed = single.forceErrorBound + c.rounding() * c.weight(water.density());
        BUOYANCY_EXPECT(off <= allowed, "%g N, the bound is %g N", off, allowed);
    }
}

/// Higher up, no more is wet.
void checkRaised(const HydrostaticResult& low, Case c, const FlatWater& water, double by) {
    c.pose.position += by * water.frame().upWorld();
    const HydrostaticResult high = evaluateExact(c.hull, c.pose, water, c.query);
    const double more = (high.submergedVolume - low.submergedVolume) / c.volume();
    BUOYANCY_EXPECT(more <= 2 * c.rounding(), "%g of the volume more at %g m higher", more, by);
}

void checkInStillWater(const Case& c, Input& input) {
    const FlatWater water(readFrame(input));
    Case inWater = c;
    inWater.pose.position += water.frame().originWorld();
    const HydrostaticResult exact = evaluateExact(c.hull, inWater.pose, water, c.query);
    checkPossible(exact, inWater, water);
    for (Evaluator evaluator : others)
        checkSame(evaluator(c.hull, inWater.pose, water, c.query), exact, inWater, water.density());
    checkComplement(exact, inWater, water);
    checkSingle(exact, inWater, water);
    checkRaised(exact, inWater, water, magnitude(input, 1e-9, 1) * c.hull.bounds.radius);
}

std::vector<WaveComponent> readWaves(Input& input, double steepness) {
    std::vector<WaveComponent> waves(std::size_t(1 + input.index(3)));
    for (WaveComponent& wave : waves) {
        wave.wavenumber = magnitude(input, 0.02, 20);
        wave.amplitude = steepness / double(waves.size()) / wave.wavenumber;
        wave.frequency = frequencyOfWavenumber(wave.wavenumber);
        wave.direction = pi * input.unit();
        wave.phase = pi * input.unit();
    }
    return waves;
}

/// All are within their own bounds of the truth, and so within both bounds of one another.
void checkBounds(const HydrostaticResult& a, const HydrostaticResult& b, const Case& c, double density) {
    BUOYANCY_EXPECT(a.forceWorld.allFinite() && a.torqueAboutCom.allFinite(), "a force of %g N",
                    a.forceWorld.norm());
    BUOYANCY_EXPECT(std::isfinite(a.forceErrorBound), "a bound of %g N", a.forceErrorBound);
    const double off = (a.forceWorld - b.forceWorld).norm();
    const double allowed = a.forceErrorBound + b.forceErrorBound + 10 * c.rounding() * c.weight(density);
    BUOYANCY_EXPECT(off <= allowed, "%g N, the bounds are %g and %g N", off, a.forceErrorBound,
                    b.forceErrorBound);
}

void checkInWaves(Case c, const WaterField& water, Input& input) {
    // Over a body of many wavelengths the head, which goes on above the surface, passes all numbers.
    const bool mayDecay = water.bounds().curvature * c.hull.bounds.radius < 1;
    if (input.coin() && mayDecay) c.query.pressure = PressureModel::waveDynamic;
    c.pose.position += water.frame().originWorld();
    c.query.tolerance = 1e-4;
    const HydrostaticResult fine = evaluateExact(c.hull, c.pose, water, c.query);
    c.query.tolerance = magnitude(input, 1e-3, 1e-1);
    checkBounds(evaluateExact(c.hull, c.pose, water, c.query), fine, c, water.density());
    for (Evaluator evaluator : others)
        checkBounds(evaluator(c.hull, c.pose, water, c.query), fine, c, water.density());
    c.query.precision = Precision::single;
    checkBounds(evaluateClustered(c.hull, c.pose, water, c.query), fine, c, water.density());
}

void checkCase(Input& input) {
    const HullResult made = readHull(input);
    checkHull(made);
    if (!made.hull) return;
    const Hull& hull = *made.hull;
    Case c{hull, {}, readQuery(input)};
    c.pose.orientation = readTurn(input);
    c.pose.position = 1.2 * hull.bounds.radius * input.inCube() - c.pose.orientation * hull.bounds.centre;
    switch (input.index(evaluatedWaters)) {
        case airyWater:
            return checkInWaves(c, AiryWaves(readFrame(input), {readWaves(input, 0.4)}), input);
        case gerstnerWater:
            return checkInWaves(c, GerstnerWaves(readFrame(input), {readWaves(input, 0.6)}), input);
        default:
            checkInStillWater(c, input);
    }
}

}  // namespace
}  // namespace bullet_buoyancy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    bullet_buoyancy::fuzz::Input input(bytes, size);
    bullet_buoyancy::fuzz::checkCase(input);
    return 0;
}
