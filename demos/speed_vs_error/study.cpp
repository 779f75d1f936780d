#include "speed_vs_error/study.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "scenes/fnv1a.h"
#include "scenes/interruption.h"
#include "scenes/statistics.h"
#include "scenes/stopwatch.h"
#include "scenes/study_cases.h"

namespace bullet_buoyancy::demo {

namespace {

using namespace scenes;

/// What the reference leaves undecided in waves and of round solids, and how near to round solids the library
/// integrates (see `evaluateExact`), over the weight.
constexpr double errorOfReference = 1e-8, errorOfSolids = 2e-8;

constexpr double anyTolerance = std::numeric_limits<double>::quiet_NaN();

/// An evaluator at a tolerance, ready for the hull and water of the study.
struct Run {
    const Evaluator* evaluator;
    double tolerance;
    std::unique_ptr<ReadyEvaluator> ready;
    int passes;                              // over the poses, in a block
    std::vector<double> nanoseconds, speed;  // one a round

    Wrench evaluate(const StudyCase& c) const {
        HydrostaticQuery query;
        query.time = c.time;
        if (!std::isnan(tolerance)) query.tolerance = tolerance;
        return ready->evaluate(c.pose, query);
    }
};

std::vector<double> tolerancesOf(const Evaluator& evaluator, bool isFlat) {
    const ToleranceCounts counts = evaluator.toleranceCounts;
    if (counts == ToleranceCounts::never || (counts == ToleranceCounts::inWaves && isFlat))
        return {anyTolerance};
    return {1e-1, 1e-2, 1e-3, 1e-4, 0};
}

std::vector<Run> allRuns(const Hull& hull, const WaterField& water) {
    std::vector<Run> runs;
    for (const Evaluator& evaluator : evaluators())
        for (double tolerance : tolerancesOf(evaluator, water.bounds().isFlat()))
            runs.push_back({&evaluator, tolerance, evaluator.prepare(hull, water), 1, {}, {}});
    return runs;
}

/// The sum of what was evaluated, so that no evaluation is optimized away.
volatile double sink;

/// ns an evaluation.
double timeOf(const Run& run, const std::vector<StudyCase>& cases) {
    double sum = 0;
    const double start = processorTime();
    for (int pass = 0; pass < run.passes; ++pass)
        for (const StudyCase& c : cases)
            sum += run.evaluate(c).forceWorld.z();
    const double passed = processorTime() - start;
    sink = sum;
    return passed * 1e9 / run.passes / double(cases.size());
}

/// In turn, so that what else the machine does falls on all alike.
void timeAll(std::vector<Run>& runs, const std::vector<StudyCase>& cases, int rounds) {
    constexpr double block = 3e5;  // ns, long enough for the clock
    for (Run& run : runs) {
        const double pass = timeOf(run, cases) * double(cases.size());
        run.passes = int(std::clamp(std::ceil(block / pass), 1.0, 1000.0));
    }
    for (int round = 0; round < rounds; ++round)
        for (Run& run : runs) {
            throwIfInterrupted();
            run.nanoseconds.push_back(timeOf(run, cases));
            run.speed.push_back(runs.front().nanoseconds.back() / run.nanoseconds.back());
        }
}

/// Of the evaluator's own class and what cannot be told with this hull in this water.
double allowedError(const Evaluator& evaluator, const Hull& hull, bool isFlat) {
    const bool isRound = !hull.spheres.empty() || !hull.solids.empty();
    return evaluator.error + (isRound ? errorOfSolids : 0) + (isRound || !isFlat ? errorOfReference : 0);
}

SpeedRow rowOf(const Run& run, const Hull& hull, const WaterField& water, const std::vector<StudyCase>& cases,
               const std::vector<HydrostaticResult>& truths, Fnv1a& hash) {
    SpeedRow row{};
    row.evaluator = run.evaluator;
    row.tolerance = run.tolerance;
    row.nanoseconds = median(run.nanoseconds);
    row.speed = median(run.speed);
    const double weight = water.density() * HydrostaticQuery().gravity * hull.moments.volume;
    const double allowed = allowedError(*run.evaluator, hull, water.bounds().isFlat());
    std::vector<double> force, torque;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const Wrench wrench = run.evaluate(cases[i]);
        const double bound = wrench.forceErrorBound / weight;
        force.push_back((wrench.forceWorld - truths[i].forceWorld).norm() / weight);
        torque.push_back((wrench.torqueAboutCom - truths[i].torqueAboutCom).norm() / weight /
                         hull.bounds.radius);
        row.largestBound = std::max(row.largestBound, bound);
        if (!run.evaluator->isOfTheLibrary()) continue;
        // So that NaN is broken too.
        if (!(force.back() <= bound + allowed && (bound > 0 || torque.back() <= allowed))) ++row.broken;
        hash.add(wrench.forceWorld);
        hash.add(wrench.torqueAboutCom);
    }
    row.medianError = median(force);
    row.largestError = largest(force);
    row.medianTorque = median(torque);
    row.largestTorque = largest(torque);
    return row;
}

}  // namespace

std::vector<SpeedRow> studySpeed(const NamedHull& named, const NamedSea& sea, const StudyEffort& effort,
                                 Fnv1a& hash, const std::function<void(double)>& reached) {
    const Hull& hull = *named.hull;
    const WaterField& water = *sea.water;
    const int triangles = int(asMesh(hull).triangles.size());
    const int poses =
        std::clamp(effort.trianglesInABlock / triangles, effort.posesForErrors, effort.mostPoses);
    const std::vector<StudyCase> cases = casesAcross(water, hull, poses);
    std::vector<HydrostaticResult> truths;
    for (int i = 0; i < effort.posesForErrors; ++i) {
        throwIfInterrupted();
        reached(double(i) / effort.posesForErrors);
        HydrostaticQuery query;
        query.time = cases[std::size_t(i)].time;
        truths.push_back(evaluateReference(hull, cases[std::size_t(i)].pose, water, query));
    }
    std::vector<Run> runs = allRuns(hull, water);
    timeAll(runs, cases, effort.rounds);
    std::vector<SpeedRow> rows;
    for (const Run& run : runs) {
        rows.push_back(rowOf(run, hull, water, cases, truths, hash));
        rows.back().water = sea.name;
        rows.back().hull = named.name;
        rows.back().triangles = triangles;
    }
    return rows;
}

}  // namespace bullet_buoyancy::demo
