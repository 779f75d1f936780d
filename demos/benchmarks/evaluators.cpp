#include "speed_vs_error/evaluators.h"

#include <benchmark/benchmark.h>

#include "benchmarks/benchmarks.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "scenes/study_cases.h"
#include "scenes/study_hulls.h"
#include "scenes/study_seas.h"

namespace bullet_buoyancy::demo {

namespace {

using namespace scenes;

/// Evaluations of one hull across one water, each in another of many poses.
void evaluate(benchmark::State& state, const Evaluator& evaluator, const Hull& hull,
              const WaterField& water) {
    constexpr int poses = 1000;
    const std::vector<StudyCase> cases = casesAcross(water, hull, poses);
    const std::unique_ptr<ReadyEvaluator> ready = evaluator.prepare(hull, water);
    HydrostaticQuery query;
    std::size_t next = 0;
    for (auto _ : state) {
        const StudyCase& c = cases[next++ % cases.size()];
        query.time = c.time;
        benchmark::DoNotOptimize(ready->evaluate(c.pose, query));
    }
}

void addHull(const NamedHull& hull, const NamedSea& sea) {
    const std::string triangles = std::to_string(asMesh(*hull.hull).triangles.size());
    for (const Evaluator& evaluator : evaluators())
        benchmark::RegisterBenchmark(
            (evaluator.name + '/' + hull.name + ' ' + triangles + '/' + sea.name).c_str(),
            [&evaluator, hull, sea](benchmark::State& state) {
                evaluate(state, evaluator, *hull.hull, *sea.water);
            });
}

}  // namespace

void addEvaluators() {
    const NamedSea flat{"flat water", std::make_shared<FlatWater>(WaterFrame::zUp()), 0};
    const std::vector<NamedSea> seas = threeSeas();
    for (const NamedHull& hull : hullsOfAllKinds()) {
        addHull(hull, flat);
        for (const NamedSea& sea : seas)
            addHull(hull, sea);
    }
}

}  // namespace bullet_buoyancy::demo
