#include <benchmark/benchmark.h>

#include "benchmarks/benchmarks.h"

int main(int argc, char** argv) {
    bullet_buoyancy::demo::addEvaluators();
    bullet_buoyancy::demo::addWaters();
    bullet_buoyancy::demo::addAction();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
