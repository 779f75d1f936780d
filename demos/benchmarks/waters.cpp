#include <benchmark/benchmark.h>

#include "benchmarks/benchmarks.h"
#include "scenes/study_seas.h"

namespace bullet_buoyancy::demo {

namespace {

using namespace scenes;

/// Asks a water about many points at once, `state.range()` of them.
template <typename Ask>
void add(const std::string& question, const NamedSea& sea, const Ask& ask) {
    benchmark::RegisterBenchmark((question + '/' + sea.name).c_str(),
                                 [sea, ask](benchmark::State& state) {
                                     const Eigen::Index points = state.range();
                                     auto run = ask(*sea.water, points);
                                     double time = 0;
                                     for (auto _ : state) {
                                         run(time);
                                         time += 0.01;
                                     }
                                     state.SetItemsProcessed(state.iterations() * points);
                                 })
        ->Arg(1)
        ->Arg(64)
        ->Arg(1024);
}

Eigen::ArrayX3d placesOf(Eigen::Index points) {
    Eigen::ArrayX3d places(points, 3);
    for (Eigen::Index i = 0; i < points; ++i)
        places.row(i) << double(i % 32), double(i / 32), -1;
    return places;
}

}  // namespace

void addWaters() {
    for (const NamedSea& sea : threeSeas()) {
        add("sampleSurface", sea, [](const WaterField& water, Eigen::Index points) {
            return [&water, places = Eigen::ArrayX2d(placesOf(points).leftCols<2>()),
                    samples = Eigen::ArrayX3d(points, 3)](double time) mutable {
                water.sampleSurface(places, time, samples);
                benchmark::DoNotOptimize(samples.data());
            };
        });
        add("expandSurface", sea, [](const WaterField& water, Eigen::Index points) {
            return [&water, places = Eigen::ArrayX2d(placesOf(points).leftCols<2>()),
                    expansions = Eigen::Array<double, Eigen::Dynamic, 7>(points, 7)](double time) mutable {
                water.expandSurface(places, time, expansions);
                benchmark::DoNotOptimize(expansions.data());
            };
        });
        add("sampleVelocity", sea, [](const WaterField& water, Eigen::Index points) {
            return [&water, places = placesOf(points),
                    velocities = Eigen::ArrayX3d(points, 3)](double time) mutable {
                water.sampleVelocity(places, time, velocities);
                benchmark::DoNotOptimize(velocities.data());
            };
        });
    }
}

}  // namespace bullet_buoyancy::demo
