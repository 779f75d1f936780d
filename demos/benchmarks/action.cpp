#include <benchmark/benchmark.h>

#include "benchmarks/benchmarks.h"
#include "scenes/timed_scene.h"

namespace bullet_buoyancy::demo {

namespace {

using namespace scenes;

/// The action's part of a substep, for `state.range()` bodies.
void step(benchmark::State& state, const NamedShapes& shapes) {
    constexpr int settling = 60;  // substeps, from where they were put to how they float
    TimedScene scene(shapes, int(state.range()));
    for (int i = 0; i < settling; ++i)
        scene.step();
    for (auto _ : state)
        state.SetIterationTime(scene.step().action * 1e-9);
    state.SetItemsProcessed(state.iterations() * state.range());
}

}  // namespace

void addAction() {
    for (const NamedShapes& shapes : shapesOfScenes())
        benchmark::RegisterBenchmark((std::string("action/") + shapes.name).c_str(),
                                     [shapes](benchmark::State& state) { step(state, shapes); })
            ->Arg(1000)
            ->UseManualTime();
}

}  // namespace bullet_buoyancy::demo
