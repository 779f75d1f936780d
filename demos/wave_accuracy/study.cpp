#include "wave_accuracy/study.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "bullet_buoyancy/hull/tessellate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/interruption.h"
#include "scenes/statistics.h"
#include "scenes/study_hulls.h"
#include "scenes/wigley_hull.h"

namespace bullet_buoyancy::demo {

using namespace scenes;

namespace {

const FlatWater& flatWater() {
    static const FlatWater water(WaterFrame::zUp());
    return water;
}

StudyHull hullOf(const std::string& name, HullPart part, double length) {
    return {name, makeHull(std::vector<HullPart>{std::move(part)}).hull, length};
}

/// us a call: the best of several blocks, each long enough for the clock.
template <typename Work>
double microsecondsOf(const Work& work) {
    using Clock = std::chrono::steady_clock;
    constexpr int blocks = 7;
    constexpr double block = 20;  // us
    int calls = 1;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < blocks; ++i) {
        const auto start = Clock::now();
        for (int call = 0; call < calls; ++call)
            work();
        const std::chrono::duration<double, std::micro> passed = Clock::now() - start;
        best = std::min(best, passed.count() / calls);
        calls = std::clamp(int(block / best), 1, 1000);
    }
    return best;
}

/// The sum of what was evaluated, so that no evaluation is optimized away.
volatile double sink;

double timeOf(const Hull& hull, const Pose& pose, const WaterField& water, const HydrostaticQuery& query) {
    return microsecondsOf([&] { sink = evaluateExact(hull, pose, water, query).forceWorld.z(); });
}

/// One figure for each case.
struct Figures {
    std::vector<double> error, bound, torque, samples, microseconds, inFlatWater;
};

ToleranceRow summaryOf(const Figures& figures, double tolerance) {
    ToleranceRow row{};
    row.tolerance = tolerance;
    row.medianError = median(figures.error);
    row.largestError = largest(figures.error);
    row.medianBound = median(figures.bound);
    row.medianTorque = median(figures.torque);
    row.largestTorque = largest(figures.torque);
    row.samples = median(figures.samples);
    row.microseconds = median(figures.microseconds);
    row.overFlat = row.microseconds / median(figures.inFlatWater);
    for (std::size_t i = 0; i < figures.error.size(); ++i) {
        row.shareOver += (figures.bound[i] > tolerance) / double(figures.error.size());
        // So that NaN is broken too.
        if (!(figures.error[i] <= figures.bound[i] + errorOfReference)) ++row.brokenBounds;
    }
    return row;
}

}  // namespace

std::vector<StudyHull> studyHulls(double length) {
    WigleyDef wigley;
    wigley.length = length;
    wigley.beam = length / 5;
    wigley.draft = wigley.freeboard = length / 10;
    const double radius = length / 6;
    const Vec3 cap((length / 2 - radius), 0, 0);
    return {hullOf("box", boxMesh({length, length / 2, length / 4}), length),
            hullOf("Wigley hull", wigleyMesh(wigley), length),
            hullOf("capsule", makeTaperedCapsule(-cap, radius, cap, radius), length), icosphere(length, 2)};
}

StudyHull icosphere(double diameter, int levels) {
    return hullOf("icosphere", tessellate(Sphere{Vec3::Zero(), diameter / 2}, levels), diameter);
}

std::vector<ToleranceRow> studyTolerances(const StudyHull& hull, const WaterField& water,
                                          const std::vector<StudyCase>& cases, PressureModel pressure,
                                          const std::function<void(std::size_t)>& reached) {
    constexpr double tolerances[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 0};
    HydrostaticQuery query;
    query.pressure = pressure;
    const double weight = water.density() * query.gravity * hull.hull->moments.volume;
    std::vector<Figures> figures(std::size(tolerances));
    for (const StudyCase& c : cases) {
        throwIfInterrupted();
        reached(std::size_t(&c - cases.data()));
        query.time = c.time;
        const HydrostaticResult truth = evaluateReference(*hull.hull, c.pose, water, query);
        for (std::size_t i = 0; i < std::size(tolerances); ++i) {
            query.tolerance = tolerances[i];
            const HydrostaticResult result = evaluateExact(*hull.hull, c.pose, water, query);
            Figures& f = figures[i];
            f.error.push_back((result.forceWorld - truth.forceWorld).norm() / weight);
            f.bound.push_back(result.forceErrorBound / weight);
            f.torque.push_back((result.torqueAboutCom - truth.torqueAboutCom).norm() / weight / hull.length);
            f.samples.push_back(result.waterSamples);
            f.microseconds.push_back(timeOf(*hull.hull, c.pose, water, query));
            f.inFlatWater.push_back(timeOf(*hull.hull, c.inFlatWater, flatWater(), query));
        }
    }
    std::vector<ToleranceRow> rows;
    for (std::size_t i = 0; i < std::size(tolerances); ++i)
        rows.push_back(summaryOf(figures[i], tolerances[i]));
    return rows;
}

SampleCount countSamples(const StudyHull& hull, const WaterField& water, const std::vector<StudyCase>& cases,
                         const HydrostaticQuery& query) {
    std::vector<double> samples, microseconds;
    for (const StudyCase& c : cases) {
        throwIfInterrupted();
        HydrostaticQuery now = query;
        now.time = c.time;
        samples.push_back(evaluateExact(*hull.hull, c.pose, water, now).waterSamples);
        microseconds.push_back(timeOf(*hull.hull, c.pose, water, now));
    }
    return {median(samples), median(microseconds)};
}

}  // namespace bullet_buoyancy::demo
